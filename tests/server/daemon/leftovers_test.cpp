// An upload that a killed goniod had half stored goes with the next start on the folder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "measured/synthetic_merl.h"
#include "measured/temp_folder.h"
#include "server/support/goniod.h"
#include "wire/sha256.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::glossy_example;
using gonio::testing::TempFolder;
using gonio::testing::write_merl;

TEST(Goniod, WhatAKilledServerHalfStoredGoesWithTheNextStart) {
  const TempFolder folder, other;
  ASSERT_TRUE(write_merl(other / "x.binary", glossy_example));
  std::ifstream in(other / "x.binary", std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  const auto leftovers = [&] {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
      count += entry.path().filename().string().rfind(".put-", 0) == 0 ? 1U : 0U;
    return count;
  };
  {
    Daemon first({"--listen", "127.0.0.1:0", "--materials", (folder / "").string()});
    const auto stub = stub_for("127.0.0.1:" + std::to_string(first.port()));
    std::thread watcher([&] {
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
      while (leftovers() == 0 && std::chrono::steady_clock::now() < end) {
      }
      first.send(SIGKILL);
    });
    grpc::ClientContext context;
    v1::PutMaterialResponse response;
    const auto call = stub->PutMaterial(&context, &response);
    v1::PutMaterialRequest part;
    part.mutable_file()->set_name("grey");
    part.mutable_file()->set_size(content.size());
    const auto sum = wire::sha256(content);
    part.mutable_file()->set_sha256(std::string(sum.begin(), sum.end()));
    call->Write(part);
    for (std::size_t at = 0; at < content.size(); at += 1 << 20) {
      part.set_chunk(content.substr(at, 1 << 20));
      if (!call->Write(part)) break;
    }
    call->WritesDone();
    EXPECT_FALSE(call->Finish().ok());
    watcher.join();
    EXPECT_EQ(first.wait_for_exit(), -SIGKILL);
  }
  ASSERT_EQ(leftovers(), 1U);
  Daemon second({"--listen", "127.0.0.1:0", "--materials", (folder / "").string()});
  EXPECT_NE(second.line_with("removed 1 unfinished"), "");
  EXPECT_GT(second.port(), 0);
  EXPECT_EQ(leftovers(), 0U);
}

}  // namespace
}  // namespace gonio::server::testing
