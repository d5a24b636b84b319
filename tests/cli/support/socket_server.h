// A server in the test's process for the tool to reach, on a socket in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "cli/support/run_process.h"
#include "measured/temp_folder.h"
#include "server/server.h"

namespace gonio::test {

class SocketServer {
 public:
  // Holds `materials`, each JSON by its name.
  explicit SocketServer(const std::map<std::string, std::string>& materials = {}) {
    std::filesystem::create_directory(folder());
    for (const auto& [name, content] : materials) write_file(folder() / (name + ".json"), content);
    server::ServerOptions options;
    options.addresses = {address()};
    options.materials = folder();
    options.fits_give_way = false;  // to other tests that run beside
    auto server = server::Server::start(options);
    EXPECT_TRUE(server.ok()) << (server ? "" : server.error().message);
    if (server) server_ = std::move(*server);
  }

  [[nodiscard]] std::string address() const { return "unix:" + (temporary_ / "socket").string(); }
  // Where its materials lie.
  [[nodiscard]] std::filesystem::path folder() const { return temporary_ / "materials"; }

 private:
  gonio::testing::TempFolder temporary_;
  std::unique_ptr<server::Server> server_;
};

}  // namespace gonio::test
