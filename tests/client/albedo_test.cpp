// Albedos through the client: estimates that agree with the samples, for every number of
// directions.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "client/support/sample_fixture.h"
#include "gonio/client/client.h"

namespace gonio::test {
namespace {

using client::SampleBatch;
using client::Sequence;

class AlbedoTest : public SampleTest {};

TEST_F(AlbedoTest, Albedos) {
  const std::vector<float> wi = {0, 0, 1, 0.6F, 0, 0.8F, 0, 0, -1};
  auto one = connect("unix").integrate(ggx(), wi, 20'000, {Sequence::random, 1});
  ASSERT_TRUE(one.ok()) << one.error().message;
  ASSERT_EQ(one->albedo.size(), 9U);
  EXPECT_EQ(one->flags, (std::vector<std::uint8_t>{0, 0, client::flag::incident_below_horizon}));
  auto sobol = connect("unix").integrate(ggx(), wi, 16'384, {Sequence::sobol, 1});
  ASSERT_TRUE(sobol.ok());
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_GT(one->standard_error[k], 0);
    EXPECT_NEAR(one->albedo[k], sobol->albedo[k], 5 * one->standard_error[k]);
  }
  EXPECT_EQ(one->report.pairs, 60'000U);
  auto none = connect("unix").integrate(ggx(), std::span<const float>(), 2);
  ASSERT_TRUE(none.ok());
  EXPECT_EQ(none->report.channels, 3);
}

// More directions than go into one call.
TEST_F(AlbedoTest, ManyAlbedosAreTheSameAsOneByOne) {
  const auto wi = directions<double>(3000);
  auto all = connect("unix").integrate(ggx(), wi, 64);
  ASSERT_TRUE(all.ok()) << all.error().message;
  ASSERT_EQ(all->lost.size(), 3000U);
  SampleBatch<double> batch;
  batch.wi = wi;
  batch.per_wi = 64;
  batch.first = 2999 * 64;
  const auto last = drawn(connect("unix"), batch, 64);
  double sum = 0;
  for (std::size_t i = 0; i < 64; ++i) sum += last.weights[3 * i];
  EXPECT_NEAR(all->albedo[3 * 2999], sum / 64, 1e-14);
}

// An albedo is that of its direction, however many others are asked for with it.
TEST_F(AlbedoTest, AlbedosOfEveryNumberOfDirectionsAreTheSame) {
  const auto wi = directions<float>(4001);
  const auto all = connect("unix").integrate(ggx(), wi, 16);
  ASSERT_TRUE(all.ok()) << all.error().message;
  for (const std::size_t size : {1U, 2U, 3U, 5U, 4001U}) {
    const auto some = connect("unix").integrate(ggx(), std::span(wi).first(3 * size), 16);
    ASSERT_TRUE(some.ok()) << some.error().message;
    ASSERT_EQ(some->albedo.size(), 3 * size);
    EXPECT_TRUE(std::equal(some->albedo.begin(), some->albedo.end(), all->albedo.begin())) << size;
    EXPECT_TRUE(std::equal(some->flags.begin(), some->flags.end(), all->flags.begin())) << size;
  }
}

}  // namespace
}  // namespace gonio::test
