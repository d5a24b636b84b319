// The client against a real server whose queue takes fewer chunks than the client has in flight.
#include <gtest/gtest.h>

#include <vector>

#include "client/support/pairs.h"
#include "client/support/server_fixture.h"

namespace gonio::test {
namespace {

constexpr std::size_t kPairs = 300'000;

class FullQueue : public ServerFixture, public ::testing::WithParamInterface<std::size_t> {
 protected:
  void SetUp() override {
    server::ServerOptions options;
    options.addresses = {"127.0.0.1:0"};
    options.threads = 1;
    options.max_queued_jobs = GetParam();
    auto server = server::Server::start(options);
    ASSERT_TRUE(server.ok()) << server.error().message;
    server_ = std::move(server).value();
  }

  static client::ClientOptions eager() {
    client::ClientOptions options;
    options.backoff = std::chrono::milliseconds(5);
    options.chunk_pairs = 5000;
    options.in_flight = 16;
    options.max_retries = 1;
    return options;
  }

  const RandomPairs<float> pairs_{kPairs};
};

TEST_P(FullQueue, IsNoErrorForArrays) {
  const auto client = connect("tcp", eager());
  std::vector<float> values(3 * kPairs, -1), expected(3 * kPairs);
  auto report = client.evaluate(ggx(), pairs_.wi, pairs_.wo, values);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->pairs, kPairs);
  auto patient = eager();
  patient.in_flight = 1;
  ASSERT_TRUE(connect("tcp", patient).evaluate(ggx(), pairs_.wi, pairs_.wo, expected).ok());
  EXPECT_EQ(values, expected);
}

TEST_P(FullQueue, IsNoErrorForASinkInOrder) {
  const auto client = connect("tcp", eager());
  std::size_t given = 0, taken = 0;
  const client::PairSource<float> source = [&](std::span<float> wi, std::span<float> wo) {
    const std::size_t count = std::min(wi.size() / 3, kPairs - given);
    std::copy_n(pairs_.wi.data() + 3 * given, 3 * count, wi.begin());
    std::copy_n(pairs_.wo.data() + 3 * given, 3 * count, wo.begin());
    given += count;
    return Result<std::size_t>(count);
  };
  const client::ChunkSink<float, float> sink = [&](const auto& chunk) {
    EXPECT_EQ(chunk.first, taken);
    taken += chunk.pairs;
    return Ok{};
  };
  auto report = client.evaluate_chunks<float, float>(ggx(), source, sink);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(taken, kPairs);
}

INSTANTIATE_TEST_SUITE_P(Places, FullQueue, ::testing::Values(1, 2));

}  // namespace
}  // namespace gonio::test
