// A real server on all three transports, and clients for each.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "gonio/client/client.h"
#include "measured/temp_folder.h"
#include "server/server.h"

namespace gonio::test {

class ServerFixture : public ::testing::Test {
 protected:
  void SetUp() override { start(); }

  void start(int threads = 2) {
    server::ServerOptions options;
    options.addresses = {"127.0.0.1:0", "unix:" + (folder_ / "socket").string()};
    options.threads = threads;
    auto server = server::Server::start(options);
    ASSERT_TRUE(server.ok()) << server.error().message;
    server_ = std::move(server).value();
  }

  [[nodiscard]] std::string tcp() const { return "127.0.0.1:" + std::to_string(server_->port()); }
  [[nodiscard]] std::string unix_socket() const { return "unix:" + (folder_ / "socket").string(); }

  // "tcp", "unix" or "in-process".
  [[nodiscard]] client::Client connect(const std::string& transport,
                                       const client::ClientOptions& options = {}) const {
    auto made =
        transport == "in-process"
            ? client::Client::from_channel(server_->in_process_channel(), "in-process", options)
            : client::Client::connect(transport == "tcp" ? tcp() : unix_socket(), options);
    EXPECT_TRUE(made.ok());
    return std::move(made).value();
  }

  static client::Material ggx() {
    return client::Material::model(
        "ggx", {{"f0", std::vector{1.0, 0.71, 0.29}}, {"alpha_x", 0.2}, {"alpha_y", 0.1}});
  }

  gonio::testing::TempFolder folder_;
  std::unique_ptr<server::Server> server_;
};

}  // namespace gonio::test
