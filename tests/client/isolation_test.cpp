// Many users at once: each gets exactly what it would get alone.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <span>
#include <thread>
#include <vector>

#include "client/support/pairs.h"
#include "client/support/server_fixture.h"
#include "gonio/client/client.h"

namespace gonio::test {
namespace {

using client::ClientOptions;
using client::Material;

constexpr std::size_t kPairs = 50000;

struct Answer {
  std::vector<float> values = std::vector<float>(3 * kPairs, -1);
  std::vector<std::uint8_t> flags = std::vector<std::uint8_t>(kPairs, 255);

  bool operator==(const Answer& other) const {
    return std::memcmp(values.data(), other.values.data(), values.size() * sizeof(float)) == 0 &&
           flags == other.flags;
  }
};

Answer evaluate(const client::Client& client, const Material& material,
                const RandomPairs<float>& pairs) {
  Answer answer;
  auto report = client.evaluate(material, pairs.wi, pairs.wo, answer.values, answer.flags);
  EXPECT_TRUE(report.ok()) << report.error().message;
  return answer;
}

// Every third pair is wrong in one way or another.
RandomPairs<float> bad_pairs() {
  RandomPairs<float> pairs(kPairs, 7);
  const float wrong[] = {std::numeric_limits<float>::quiet_NaN(),
                         std::numeric_limits<float>::infinity(), 0.0F, 1e30F, -1e-40F};
  for (std::size_t i = 0; i < pairs.wi.size(); i += 9) pairs.wi[i] = wrong[i % 5];
  return pairs;
}

class Isolation : public ServerFixture {};

TEST_F(Isolation, BadPairsOfOneClientDoNotReachAnother) {
  ClientOptions options;
  options.chunk_pairs = 777;
  const RandomPairs<float> good(kPairs), bad = bad_pairs();
  const Answer good_alone = evaluate(connect("tcp"), ggx(), good);
  const Answer bad_alone = evaluate(connect("tcp"), ggx(), bad);
  for (int round = 0; round < 5; ++round) {
    Answer good_together, bad_together;
    std::thread other([&] { bad_together = evaluate(connect("tcp", options), ggx(), bad); });
    good_together = evaluate(connect("tcp", options), ggx(), good);
    other.join();
    EXPECT_TRUE(good_together == good_alone);
    EXPECT_TRUE(bad_together == bad_alone);
  }
}

TEST_F(Isolation, OneClientServesManyThreads) {
  ClientOptions options;
  options.chunk_pairs = 3000;
  const auto client = connect("unix", options);
  const RandomPairs<float> pairs(kPairs);
  const Answer expected = evaluate(client, ggx(), pairs);
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&] { EXPECT_TRUE(evaluate(client, ggx(), pairs) == expected); });
  }
  for (auto& thread : threads) thread.join();
}

// Calls of one client take turns with what it keeps between them.
TEST_F(Isolation, SmallCallsOfManyThreadsGetTheirOwnAnswers) {
  constexpr std::size_t kCalls = 300;
  const auto client = connect("unix");
  const RandomPairs<float> pairs(kPairs);
  const Answer expected = evaluate(client, ggx(), pairs);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 8; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t call = 0; call < kCalls; ++call) {
        const std::size_t first = t * kCalls + call, count = 1 + call % 3;
        std::vector<float> values(3 * count);
        const auto report =
            client.evaluate(ggx(), std::span(pairs.wi).subspan(3 * first, 3 * count),
                            std::span(pairs.wo).subspan(3 * first, 3 * count), values);
        ASSERT_TRUE(report.ok()) << report.error().message;
        EXPECT_EQ(0, std::memcmp(values.data(), &expected.values[3 * first], 12 * count)) << first;
      }
    });
  }
  for (auto& thread : threads) thread.join();
}

TEST_F(Isolation, ThreadsOfTheServerChangeNoBit) {
  const RandomPairs<float> pairs(kPairs);
  const Answer expected = evaluate(connect("in-process"), ggx(), pairs);
  for (const int threads : {1, 3, 8}) {
    server_.reset();
    start(threads);
    EXPECT_TRUE(evaluate(connect("in-process"), ggx(), pairs) == expected) << threads;
  }
}

}  // namespace
}  // namespace gonio::test
