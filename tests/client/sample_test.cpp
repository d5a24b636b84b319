// Samples and albedos through the client: from every transport, in chunks of every size, the same
// bits; and what is wrong is said before anything is sent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "client/support/sample_fixture.h"
#include "gonio/client/client.h"

namespace gonio::test {
namespace {

using client::NumberSource;
using client::SampleBatch;
using client::SampleChunk;
using client::Samples;
using client::Sequence;
using ::testing::HasSubstr;

TEST_F(SampleTest, TransportsAndChunksChangeNoBit) {
  const auto wi = directions<float>(37);
  SampleBatch<float> batch;
  batch.wi = wi;
  batch.per_wi = 211;
  batch.numbers = {Sequence::sobol, 4};
  client::Report report;
  const auto expected = drawn(connect("in-process"), batch, 37 * 211, &report);
  EXPECT_EQ(report.pairs, 37U * 211);
  EXPECT_EQ(report.channels, 3);
  EXPECT_GT(report.lost, 0U);
  EXPECT_EQ(report.flagged_by[4], report.lost);
  for (const char* transport : {"tcp", "unix"}) {
    for (const std::size_t chunk : {100U, 1000U, 65536U}) {
      client::ClientOptions options;
      options.chunk_pairs = chunk;
      EXPECT_EQ(drawn(connect(transport, options), batch, 37 * 211), expected) << chunk;
    }
  }
}

TEST_F(SampleTest, ARunIsAPartOfTheWhole) {
  const auto wi = directions<double>(10);
  SampleBatch<double> batch;
  batch.wi = wi;
  batch.per_wi = 100;
  batch.numbers.seed = 12;
  const auto whole = drawn(connect("unix"), batch, 1000);
  batch.first = 250;
  const auto run = drawn(connect("unix", {.chunk_pairs = 64}), batch, 300);
  EXPECT_TRUE(std::equal(run.pdf.begin(), run.pdf.end(), whole.pdf.begin() + 250));
  EXPECT_TRUE(std::equal(run.wo.begin(), run.wo.end(), whole.wo.begin() + 750));
}

TEST_F(SampleTest, BatchesOfEverySizeChangeNoBit) {
  const auto wi = directions<float>(4010);
  SampleBatch<float> batch;
  batch.wi = wi;
  const auto whole = drawn(connect("in-process"), batch, 4010);
  for (const std::size_t chunk : {3U, 1000U, 65536U}) {
    const auto client = connect("unix", {.chunk_pairs = chunk});
    for (const std::size_t size : {1U, 2U, 3U, 5U, 4001U}) {
      batch.wi = std::span(wi).first(3 * size);
      const auto part = drawn(client, batch, size);
      EXPECT_TRUE(std::equal(part.pdf.begin(), part.pdf.end(), whole.pdf.begin())) << size;
      EXPECT_TRUE(std::equal(part.wo.begin(), part.wo.end(), whole.wo.begin())) << size;
      EXPECT_TRUE(std::equal(part.weights.begin(), part.weights.end(), whole.weights.begin()))
          << size;
    }
  }
}

TEST_F(SampleTest, NumbersOfTheCallersOwn) {
  const auto wi = directions<float>(5);
  std::vector<float> xi(5 * 40 * 3);
  for (std::size_t i = 0; i < xi.size(); ++i) xi[i] = static_cast<float>(i % 97) / 97;
  SampleBatch<float> batch;
  batch.wi = wi;
  batch.per_wi = 40;
  batch.xi = xi;
  const auto one = drawn(connect("tcp"), batch, 200);
  EXPECT_EQ(drawn(connect("tcp", {.chunk_pairs = 33}), batch, 200), one);
  xi[0] = 1;
  client::Report report;
  const auto bad = drawn(connect("tcp"), batch, 200, &report);
  EXPECT_EQ(bad.flags[0], client::flag::bad_number);
  EXPECT_EQ(report.flagged_by[6], 1U);
  EXPECT_EQ(bad.pdf[1], one.pdf[1]);
}

TEST_F(SampleTest, FromASourceToASink) {
  const auto wi = directions<float>(23);
  SampleBatch<float> batch;
  batch.wi = wi;
  batch.per_wi = 50;
  batch.numbers.seed = 3;
  const auto expected = drawn(connect("unix"), batch, 23 * 50);
  for (const std::size_t chunk : {20U, 170U, 65536U}) {
    std::size_t given = 0, taken = 0;
    const client::DirectionSource<float> source = [&](std::span<float> to) {
      const std::size_t n = std::min<std::size_t>({to.size() / 3, 4, 23 - given});
      std::copy_n(wi.begin() + static_cast<std::ptrdiff_t>(3 * given), 3 * n, to.begin());
      given += n;
      return Result<std::size_t>(n);
    };
    const client::SampleSink<float> sink = [&](const SampleChunk<float>& piece) -> Outcome {
      EXPECT_EQ(piece.first, taken);
      for (std::size_t i = 0; i < piece.samples; ++i, ++taken) {
        EXPECT_EQ(piece.pdf[i], expected.pdf[taken]);
        EXPECT_EQ(piece.weights[3 * i + 1], expected.weights[3 * taken + 1]);
        EXPECT_EQ(piece.wi_of(i)[0], wi[taken / 50 * 3]);
      }
      return Ok{};
    };
    const auto client = connect("unix", {.chunk_pairs = chunk});
    auto report = client.sample_chunks<float>(ggx(), source, 50, {Sequence::random, 3}, sink);
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_EQ(report->pairs, 23U * 50);
    EXPECT_EQ(taken, 23U * 50);
  }
}

TEST_F(SampleTest, PdfsOfPairsAreThoseOfTheSamples) {
  const auto wi = directions<float>(3000);
  SampleBatch<float> batch;
  batch.wi = wi;
  const auto samples = drawn(connect("tcp"), batch, 3000);
  std::vector<float> values(9000), pdf(3000), plain(9000);
  for (const std::size_t chunk : {700U, 65536U}) {
    const auto client = connect("tcp", {.chunk_pairs = chunk});
    ASSERT_TRUE(client.evaluate_with_pdf(ggx(), wi, samples.wo, values, pdf).ok());
    EXPECT_EQ(pdf, samples.pdf);
    ASSERT_TRUE(client.evaluate(ggx(), wi, samples.wo, plain).ok());
    EXPECT_EQ(values, plain);
  }
  EXPECT_THAT(connect("tcp").evaluate_with_pdf(ggx(), wi, samples.wo, values, {}).error().message,
              HasSubstr("the length of pdf is 0"));
}

TEST_F(SampleTest, WrongLengthsAreErrors) {
  const auto wi = directions<float>(4);
  Drawn<float> to(8);
  const auto client = connect("unix");
  const auto message = [&](const SampleBatch<float>& batch, const Samples<float>& results) {
    const auto report = client.sample(ggx(), batch, results);
    return report ? std::string("accepted") : report.error().message;
  };
  SampleBatch<float> good;
  good.wi = wi;
  good.per_wi = 2;
  EXPECT_EQ(message(good, to.results()), "accepted");
  SampleBatch<float> batch = good;
  batch.per_wi = 0;
  EXPECT_THAT(message(batch, to.results()), HasSubstr("per_wi is 0"));
  batch = good;
  batch.wi = std::span(wi).first(11);
  EXPECT_THAT(message(batch, to.results()), HasSubstr("the length of wi is 11"));
  batch = good;
  batch.first = 1;
  EXPECT_THAT(message(batch, to.results()), HasSubstr("at most the 7 samples"));
  batch = good;
  batch.xi = std::span(wi).first(3);
  EXPECT_THAT(message(batch, to.results()), HasSubstr("the length of xi is 3"));
  Samples<float> results = to.results();
  results.wo = results.wo.first(3);
  EXPECT_THAT(message(good, results), HasSubstr("the length of wo is 3"));
  results = to.results();
  results.weights = results.weights.first(8);
  EXPECT_THAT(message(good, results), HasSubstr("8 samples x 3 channels"));
  EXPECT_THAT(client.integrate(ggx(), wi, 1).error().message, HasSubstr("per_wi is 1"));
}

}  // namespace
}  // namespace gonio::test
