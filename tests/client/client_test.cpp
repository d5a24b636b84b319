// The client against a real server: what comes back, from every transport and in chunks of every
// size.
#include "gonio/client/client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "client/support/pairs.h"
#include "client/support/server_fixture.h"

namespace gonio::test {
namespace {

using client::ClientOptions;
using client::EvaluateOptions;
using client::Material;

class ClientTest : public ServerFixture {};

template <class T>
struct Results {
  std::vector<T> values;
  std::vector<std::uint8_t> flags;
  client::Report report;

  bool same_as(const Results& other) const {
    return values.size() == other.values.size() && flags == other.flags &&
           std::memcmp(values.data(), other.values.data(), values.size() * sizeof(T)) == 0;
  }
};

template <class In, class Out>
Results<Out> evaluate(const client::Client& client, const Material& material,
                      const RandomPairs<In>& pairs, int channels,
                      const EvaluateOptions& options = {}) {
  Results<Out> results;
  results.values.assign(pairs.wi.size() / 3 * static_cast<std::size_t>(channels), Out{-1});
  results.flags.assign(pairs.wi.size() / 3, 255);
  auto report =
      client.evaluate(material, pairs.wi, pairs.wo, results.values, results.flags, options);
  EXPECT_TRUE(report.ok()) << report.error().message;
  if (report) results.report = *report;
  return results;
}

TEST_F(ClientTest, EvaluatesAFormula) {
  const auto material = Material::model("lambertian", {{"rd", std::vector{0.5, 0.25, 1.0}}});
  const RandomPairs<float> pairs(1000);
  const auto results = evaluate<float, float>(connect("tcp"), material, pairs, 3);
  EXPECT_EQ(results.report.pairs, 1000U);
  EXPECT_EQ(results.report.channels, 3);
  std::uint64_t flagged = 0, below_i = 0, below_o = 0;
  for (std::size_t i = 0; i < 1000; ++i) {
    const bool wi_below = pairs.wi[3 * i + 2] <= 0, wo_below = pairs.wo[3 * i + 2] <= 0;
    const float lit = wi_below || wo_below ? 0.0F : 1.0F;
    EXPECT_FLOAT_EQ(results.values[3 * i], lit * 0.5F * std::numbers::inv_pi_v<float>);
    EXPECT_FLOAT_EQ(results.values[3 * i + 2], lit * std::numbers::inv_pi_v<float>);
    EXPECT_EQ(results.flags[i], (wi_below ? client::flag::incident_below_horizon : 0) |
                                    (wo_below ? client::flag::outgoing_below_horizon : 0));
    flagged += wi_below || wo_below;
    below_i += wi_below;
    below_o += wo_below;
  }
  EXPECT_GT(flagged, 0U);
  EXPECT_EQ(results.report.flagged, flagged);
  EXPECT_EQ(results.report.flagged_by[3], below_i);
  EXPECT_EQ(results.report.flagged_by[4], below_o);
  EXPECT_EQ(results.report.precision, client::Precision::fast);
  EXPECT_GT(results.report.error_bound.relative, 0);
  EXPECT_GT(results.report.kernel_seconds, 0);
  EXPECT_NE(results.report.instruction_set, client::InstructionSet::best);
}

TEST_F(ClientTest, TransportChunksAndWindowChangeNoBit) {
  const RandomPairs<float> pairs(30011);
  const auto expected = evaluate<float, float>(connect("in-process"), ggx(), pairs, 3);
  for (const char* transport : {"tcp", "unix", "in-process"}) {
    for (const std::size_t chunk : {1000U, 4096U, 30011U, 65536U}) {
      for (const int in_flight : {1, 4, 16}) {
        ClientOptions options;
        options.chunk_pairs = chunk;
        options.in_flight = in_flight;
        const auto results = evaluate<float, float>(connect(transport, options), ggx(), pairs, 3);
        EXPECT_TRUE(results.same_as(expected)) << transport << " " << chunk << " " << in_flight;
        EXPECT_EQ(results.report.flagged, expected.report.flagged);
        EXPECT_EQ(results.report.flagged_by, expected.report.flagged_by);
        EXPECT_EQ(results.report.pairs, 30011U);
      }
    }
  }
}

TEST_F(ClientTest, BatchesOfOneChangeNoBit) {
  const RandomPairs<float> pairs(300);
  const auto expected = evaluate<float, float>(connect("tcp"), ggx(), pairs, 3);
  ClientOptions options;
  options.chunk_pairs = 1;
  EXPECT_TRUE(
      (evaluate<float, float>(connect("unix", options), ggx(), pairs, 3).same_as(expected)));
  const auto client = connect("tcp");
  for (std::size_t i = 0; i < 300; ++i) {
    float values[3];
    std::uint8_t flag = 255;
    auto report =
        client.evaluate(ggx(), {&pairs.wi[3 * i], 3}, {&pairs.wo[3 * i], 3}, values, {&flag, 1});
    ASSERT_TRUE(report.ok());
    EXPECT_EQ(std::memcmp(values, &expected.values[3 * i], sizeof(values)), 0);
    EXPECT_EQ(flag, expected.flags[i]);
  }
}

TEST_F(ClientTest, BatchesOfEverySizeChangeNoBit) {
  const RandomPairs<float> pairs(4010);
  const auto expected = evaluate<float, float>(connect("in-process"), ggx(), pairs, 3);
  for (const std::size_t chunk : {3U, 1000U, 65536U}) {
    ClientOptions options;
    options.chunk_pairs = chunk;
    const auto client = connect("unix", options);
    for (const std::size_t size : {1U, 2U, 3U, 5U, 4001U}) {
      std::vector<float> values(3 * size);
      std::vector<std::uint8_t> flags(size);
      const auto report = client.evaluate(ggx(), std::span(pairs.wi).first(3 * size),
                                          std::span(pairs.wo).first(3 * size), values, flags);
      ASSERT_TRUE(report.ok());
      EXPECT_EQ(std::memcmp(values.data(), expected.values.data(), 12 * size), 0) << size;
      EXPECT_TRUE(std::equal(flags.begin(), flags.end(), expected.flags.begin())) << size;
    }
  }
}

TEST_F(ClientTest, ReferencePrecisionInAllItsForms) {
  const RandomPairs<float> pairs(5000);
  RandomPairs<double> widened(0);
  widened.wi.assign(pairs.wi.begin(), pairs.wi.end());
  widened.wo.assign(pairs.wo.begin(), pairs.wo.end());
  ClientOptions options;
  options.chunk_pairs = 1024;
  const auto client = connect("tcp", options);
  const auto from_float = evaluate<float, double>(client, ggx(), pairs, 3);
  const auto from_double = evaluate<double, double>(client, ggx(), widened, 3);
  EXPECT_TRUE(from_float.same_as(from_double));
  EXPECT_EQ(from_float.report.precision, client::Precision::reference);
  const auto fast = evaluate<float, float>(client, ggx(), pairs, 3);
  for (std::size_t i = 0; i < fast.values.size(); ++i) {
    EXPECT_NEAR(fast.values[i], from_float.values[i], 1e-5 * from_float.values[i] + 1e-30);
  }
}

TEST_F(ClientTest, InstructionSetIsPinned) {
  EvaluateOptions options;
  options.instruction_set = client::InstructionSet::baseline;
  const RandomPairs<float> pairs(100);
  const auto results = evaluate<float, float>(connect("tcp"), ggx(), pairs, 3, options);
  EXPECT_EQ(results.report.instruction_set, client::InstructionSet::baseline);
}

TEST_F(ClientTest, ManyChannelsTravelInSmallerChunks) {
  const auto material = Material::model("lambertian", {{"rd", std::vector<double>(64, 0.5)}});
  const RandomPairs<float> pairs(40000);
  const auto results = evaluate<float, double>(connect("tcp"), material, pairs, 64);
  EXPECT_EQ(results.report.channels, 64);
  EXPECT_EQ(results.report.pairs, 40000U);
}

TEST_F(ClientTest, ChunksComeToTheSinkInOrder) {
  const RandomPairs<float> pairs(10007);
  const auto expected = evaluate<float, float>(connect("tcp"), ggx(), pairs, 3);
  ClientOptions options;
  options.chunk_pairs = 64;
  Results<float> results;
  std::vector<float> wi;
  std::size_t given = 0;
  const client::PairSource<float> source = [&](std::span<float> to_wi, std::span<float> to_wo) {
    // Uneven runs: the source may give fewer than it is asked for.
    const std::size_t count =
        std::min({to_wi.size() / 3, std::size_t{10007} - given, 1 + given % 61});
    std::copy_n(&pairs.wi[3 * given], 3 * count, to_wi.begin());
    std::copy_n(&pairs.wo[3 * given], 3 * count, to_wo.begin());
    given += count;
    return Result<std::size_t>(count);
  };
  const client::ChunkSink<float, float> sink = [&](const client::Chunk<float, float>& chunk) {
    EXPECT_EQ(chunk.first, results.flags.size());
    EXPECT_EQ(chunk.channels, 3);
    results.values.insert(results.values.end(), chunk.values.begin(), chunk.values.end());
    results.flags.insert(results.flags.end(), chunk.flags.begin(), chunk.flags.end());
    wi.insert(wi.end(), chunk.wi.begin(), chunk.wi.end());
    return Ok{};
  };
  auto report = connect("tcp", options).evaluate_chunks<float, float>(ggx(), source, sink);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(results.same_as(expected));
  EXPECT_EQ(wi, pairs.wi);
}

TEST_F(ClientTest, NoPairsStillCheckTheMaterial) {
  const auto client = connect("tcp");
  std::vector<float> none;
  auto report = client.evaluate(ggx(), none, none, none);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->pairs, 0U);
  EXPECT_EQ(report->channels, 3);
  EXPECT_FALSE(client.evaluate(Material::named("nobody"), none, none, none).ok());
  auto channels = client.channels(ggx());
  ASSERT_TRUE(channels.ok());
  EXPECT_EQ(*channels, 3);
}

}  // namespace
}  // namespace gonio::test
