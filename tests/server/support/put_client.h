// A client that puts materials, and a MERL file for it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "measured/synthetic_merl.h"
#include "measured/temp_folder.h"
#include "server/support/harness.h"
#include "wire/sha256.h"

namespace gonio::server::testing {

inline std::string read_all(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A MERL file's bytes.
inline const std::string& content() {
  static const std::string kContent = [] {
    const gonio::testing::TempFolder folder;
    EXPECT_TRUE(
        gonio::testing::write_merl(folder / "x.binary", [](double theta_h, double theta_d, double) {
          return gonio::testing::Rgb{theta_h < 1 ? 0.5 : -1, 0.25, theta_d};
        }));
    return read_all(folder / "x.binary");
  }();
  return kContent;
}

inline std::string sum_of(std::string_view bytes) {
  const auto sum = wire::sha256(bytes);
  return {sum.begin(), sum.end()};
}

inline v1::PutMaterialRequest announced(const std::string& name, std::uint64_t size,
                                        const std::string& sum) {
  v1::PutMaterialRequest request;
  request.mutable_file()->set_name(name);
  request.mutable_file()->set_size(size);
  request.mutable_file()->set_sha256(sum);
  return request;
}

inline std::vector<v1::PutMaterialRequest> chunks_of(std::string_view bytes) {
  constexpr std::size_t kChunk = 1000003;  // does not divide anything
  std::vector<v1::PutMaterialRequest> chunks;
  for (std::size_t at = 0; at < bytes.size(); at += kChunk)
    chunks.emplace_back().set_chunk(std::string(bytes.substr(at, kChunk)));
  return chunks;
}

class Put : public ::testing::Test {
 protected:
  void SetUp() override { start(options_); }

  void start(const ServerOptions& options) {
    server_.reset();
    server_ = std::make_unique<TestServer>(options);
  }

  grpc::Status send(const std::vector<v1::PutMaterialRequest>& parts,
                    v1::PutMaterialResponse* response) {
    grpc::ClientContext context;
    const auto writer = server_->stub->PutMaterial(&context, response);
    for (const auto& part : parts) {
      if (!writer->Write(part)) break;
    }
    writer->WritesDone();
    return writer->Finish();
  }
  v1::PutMaterialResponse stored(const std::string& name, const std::string& bytes = content()) {
    auto parts = chunks_of(bytes);
    parts.insert(parts.begin(), announced(name, bytes.size(), sum_of(bytes)));
    v1::PutMaterialResponse response;
    const auto status = send(parts, &response);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return response;
  }
  Error refused(const std::vector<v1::PutMaterialRequest>& parts) {
    v1::PutMaterialResponse response;
    const auto status = send(parts, &response);
    EXPECT_FALSE(status.ok());
    EXPECT_FALSE(status.error_details().empty()) << status.error_message();
    return wire::from_status(status);
  }
  Error refused(const v1::PutMaterialRequest& first, std::string_view bytes) {
    auto parts = chunks_of(bytes);
    parts.insert(parts.begin(), first);
    return refused(parts);
  }
  std::vector<std::string> names() {
    grpc::ClientContext context;
    v1::ListModelsResponse listed;
    EXPECT_TRUE(server_->stub->ListModels(&context, {}, &listed).ok());
    return {listed.materials().begin(), listed.materials().end()};
  }

  const std::string sum_ = sum_of(content());
  ServerOptions options_;
  std::unique_ptr<TestServer> server_;
};

}  // namespace gonio::server::testing
