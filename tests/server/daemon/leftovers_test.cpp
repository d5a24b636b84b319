// An upload that a killed goniod had half stored goes with the next start on the folder.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "measured/temp_folder.h"
#include "server/support/goniod.h"
#include "server/support/put_client.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::TempFolder;

std::size_t leftovers_in(const TempFolder& folder) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
    count += entry.path().filename().string().rfind(".put-", 0) == 0 ? 1U : 0U;
  return count;
}

// A put that the server does not live to answer.
void put_in_vain(int port) {
  const auto stub = stub_for("127.0.0.1:" + std::to_string(port));
  grpc::ClientContext context;
  v1::PutMaterialResponse response;
  const auto call = stub->PutMaterial(&context, &response);
  call->Write(announced("grey", content().size(), sum_of(content())));
  for (const auto& chunk : chunks_of(content())) {
    if (!call->Write(chunk)) break;
  }
  call->WritesDone();
  EXPECT_FALSE(call->Finish().ok());
}

TEST(Goniod, WhatAKilledServerHalfStoredGoesWithTheNextStart) {
  const TempFolder folder;
  {
    Daemon first({"--listen", "127.0.0.1:0", "--materials", (folder / "").string()});
    const int port = first.port();
    std::thread watcher([&] {
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
      while (leftovers_in(folder) == 0 && std::chrono::steady_clock::now() < end) {
      }
      first.send(SIGKILL);
    });
    put_in_vain(port);
    watcher.join();
    EXPECT_EQ(first.wait_for_exit(), -SIGKILL);
  }
  ASSERT_EQ(leftovers_in(folder), 1U);
  Daemon second({"--listen", "127.0.0.1:0", "--materials", (folder / "").string()});
  EXPECT_NE(second.line_with("removed 1 unfinished"), "");
  EXPECT_GT(second.port(), 0);
  EXPECT_EQ(leftovers_in(folder), 0U);
}

}  // namespace
}  // namespace gonio::server::testing
