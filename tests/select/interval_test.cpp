#include "select/error/interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace gonio::testing {
namespace {

using select::Ratio;

TEST(Interval, StudentsQuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(select::student_quantile(0.975, 7), 2.36462, 1e-3);
  EXPECT_NEAR(select::student_quantile(0.99, 7), 2.99795, 3e-3);
  EXPECT_NEAR(select::student_quantile(0.95, 30), 1.69726, 1e-4);
  EXPECT_NEAR(select::student_quantile(0.99, 63), 2.38701, 1e-4);
  EXPECT_NEAR(select::student_quantile(0.5, 63), 0, 1e-9);
  EXPECT_NEAR(select::student_quantile(0.05, 30), -1.69726, 1e-4);
}

TEST(Interval, JackknifeOfAMeanIsItsStandardError) {
  const std::vector<Ratio> blocks{{1, 1}, {2, 1}, {4, 1}, {9, 1}};
  const auto found = select::estimate(blocks);
  EXPECT_DOUBLE_EQ(found.value, 4);
  EXPECT_NEAR(found.standard_error, std::sqrt((9 + 4 + 0 + 25) / 12.0), 1e-12);
}

TEST(Interval, DifferencesOfTheSameBlocksHaveNoNoise) {
  const std::vector<Ratio> a{{1, 1}, {2, 1}, {7, 1}}, b{{2, 1}, {3, 1}, {8, 1}};
  const auto found = select::estimate_difference(a, b);
  EXPECT_NEAR(found.value, -1, 1e-12);
  EXPECT_NEAR(found.standard_error, 0, 1e-12);
}

// Blocks of few and skew terms, as errors are: exponential.
TEST(Interval, UpperBoundsHoldAsOftenAsTheySay) {
  std::mt19937_64 random(1);
  std::exponential_distribution<double> term;
  int below = 0;
  constexpr int kTrials = 4000;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Ratio> blocks(32);
    for (Ratio& block : blocks) {
      for (int i = 0; i < 16; ++i) block.numerator += term(random), block.denominator += 1;
    }
    const auto found = select::estimate(blocks);
    const double reach = found.standard_error * select::student_quantile(0.95, 31);
    below += found.value + reach < 1 ? 1 : 0;
  }
  EXPECT_NEAR(below / static_cast<double>(kTrials), 0.05, 0.015);
}

}  // namespace
}  // namespace gonio::testing
