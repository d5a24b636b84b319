// The client and a goniod of its own process, which can be killed and frozen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "client/support/pairs.h"
#include "gonio/client/client.h"
#include "measured/temp_folder.h"

namespace gonio::test {
namespace {

using client::Client;
using client::ClientOptions;
using client::Material;
using std::chrono::milliseconds;
using ::testing::HasSubstr;

class Daemon : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string program = GONIOD_PROGRAM, listen = "--listen", address = address_;
    std::string level = "--log-level", warning = "warning";
    char* arguments[] = {program.data(), listen.data(),  address.data(),
                         level.data(),   warning.data(), nullptr};
    ASSERT_EQ(posix_spawn(&child_, program.c_str(), nullptr, nullptr, arguments, environ), 0);
    ClientOptions patient;
    patient.max_retries = 100;
    ASSERT_TRUE(Client::connect(address_, patient)->list_models().ok());
  }
  void TearDown() override {
    send(SIGCONT);
    send(SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  void send(int signal) const { ::kill(child_, signal); }

  // Endless chunks; `at_chunk` is called for each of them.
  Result<client::Report> stream(const ClientOptions& options,
                                const std::function<void(int)>& at_chunk) {
    const RandomPairs<float> pairs(options.chunk_pairs);
    const client::PairSource<float> source = [&](std::span<float> wi, std::span<float> wo) {
      std::copy(pairs.wi.begin(), pairs.wi.end(), wi.begin());
      std::copy(pairs.wo.begin(), pairs.wo.end(), wo.begin());
      return Result<std::size_t>(options.chunk_pairs);
    };
    int chunks = 0;
    const client::ChunkSink<float, float> sink = [&](const auto&) {
      at_chunk(++chunks);
      return Ok{};
    };
    return Client::connect(address_, options)
        ->evaluate_chunks<float, float>(Material::model("lambertian"), source, sink);
  }

  gonio::testing::TempFolder folder_;
  std::string address_ = "unix:" + (folder_ / "socket").string();
  pid_t child_ = 0;
};

TEST_F(Daemon, KilledInTheMiddleOfAStream) {
  ClientOptions options;
  options.chunk_pairs = 20000;
  options.max_retries = 2;
  options.backoff = milliseconds(1);
  const auto report = stream(options, [&](int chunk) {
    if (chunk == 10) send(SIGKILL);
  });
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::unavailable);
  EXPECT_THAT(report.error().message, HasSubstr(address_));
}

TEST_F(Daemon, FrozenInTheMiddleOfAStreamEndsWithTheDeadline) {
  ClientOptions options;
  options.chunk_pairs = 20000;
  options.deadline = milliseconds(1500);
  const auto report = stream(options, [&](int chunk) {
    if (chunk == 3) send(SIGSTOP);
  });
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::deadline_exceeded);
}

// More than the connection's buffers take, as one call and as a stream: what is on its way must not
// keep the call from returning.
TEST_F(Daemon, FrozenBeforeALargeBatchEndsWithTheDeadline) {
  ClientOptions options;
  options.deadline = milliseconds(700);
  auto client = Client::connect(address_, options);
  ASSERT_TRUE(client->list_models().ok());
  send(SIGSTOP);
  for (const std::size_t count : {65536U, 500000U}) {
    const RandomPairs<float> pairs(count);
    std::vector<float> values(count);
    const auto report = client->evaluate(Material::model("lambertian"), pairs.wi, pairs.wo, values);
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.error().code, ErrorCode::deadline_exceeded);
    EXPECT_THAT(report.error().message, HasSubstr(address_));
  }
}

TEST_F(Daemon, KilledBeforeALargeBatchGivesBackTheMemory) {
  const RandomPairs<float> pairs(500000);
  std::vector<float> values(500000);
  ClientOptions options;
  options.max_retries = 1;
  options.backoff = milliseconds(1);
  auto client = Client::connect(address_, options);
  ASSERT_TRUE(client->list_models().ok());
  send(SIGSTOP);
  std::thread killer([&] {
    std::this_thread::sleep_for(milliseconds(300));
    send(SIGKILL);
  });
  const auto report = client->evaluate(Material::model("lambertian"), pairs.wi, pairs.wo, values);
  killer.join();
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::unavailable);
}

}  // namespace
}  // namespace gonio::test
