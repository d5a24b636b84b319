// Each elementary function holds the error that numeric/errors.h states, on every instruction set
// that this machine has, over its whole range; worst_test.cpp looks where errors are largest.
#include <gtest/gtest.h>

#include "engine/material/flush_to_zero.h"
#include "numeric/arrays.h"
#include "numeric/cancelling.h"
#include "numeric/errors.h"

namespace gonio::testing {
namespace {

class Elementary : public ::testing::TestWithParam<Isa> {
 protected:
  const Functions& use = functions(GetParam());
  std::vector<double> out = std::vector<double>(kCount);
};

TEST_P(Elementary, LogarithmOverTheWholeRange) {
  const auto w = powers(-20, 27, 1), c = powers(-130, 2, 2);
  auto s = powers(-120, 40, 3);
  for (std::size_t i = 0; i < kCount; ++i) s[i] *= c[i];  // s/c from 1e-36 to 1e12
  const auto truth = [&](std::size_t i) {
    const long double ratio = static_cast<long double>(s[i]) / c[i];
    return static_cast<long double>(w[i]) / s[i] * std::log1p(ratio) / std::log(2.0L);
  };
  use.weighted_log2_quick(w.data(), s.data(), c.data(), kCount, out.data());
  EXPECT_LE(worst_relative(out, truth), errors::kQuickWeightedLog2Error);
  use.weighted_log2_exact(w.data(), s.data(), c.data(), kCount, out.data());
  EXPECT_LE(worst_relative(out, truth), errors::kExactWeightedLog2Error);
}

TEST_P(Elementary, LogarithmAtTheNormalIsZero) {
  const std::vector<double> zero(kCount), c(kCount, 4.0);
  use.weighted_log2_quick(zero.data(), zero.data(), c.data(), kCount, out.data());
  EXPECT_EQ(out, zero);
  use.weighted_log2_exact(zero.data(), zero.data(), c.data(), kCount, out.data());
  EXPECT_EQ(out, zero);
}

TEST_P(Elementary, ExponentialOfFloats) {
  auto x = powers(-40, 7.3, 4);
  for (double& v : x) v = -v;
  x[0] = 0, x[1] = -1, x[2] = -100, x[3] = -0x1p-60, x[4] = -1 + 0x1p-40;
  // The product is rounded as well: as many amplitudes as arguments, all with a normal result.
  const auto amplitudes = powers(32, 126, 14);
  std::vector<float> amplitude(amplitudes.begin(), amplitudes.end());
  amplitude[5] = 1.00394392F, x[5] = -0.9967551826238632;  // 2.55e-7 without FMA
  std::vector<float> got(kCount);
  const FlushToZero flush;
  use.times_exp2_quick(amplitude.data(), x.data(), kCount, got.data());
  const auto truth = [&](std::size_t i) {
    return static_cast<long double>(amplitude[i]) * std::exp2(static_cast<long double>(x[i]));
  };
  EXPECT_LE(worst_relative(got, truth), errors::kTimesExp2Error);
}

TEST_P(Elementary, ExponentialOfFloatsBeyondTheRangeIsNearlyZero) {
  std::vector<double> x(kCount, -1e12);
  x[0] = -255, x[1] = -256, x[2] = -1e300, x[3] = -HUGE_VAL;
  const std::vector<float> amplitude(kCount, 1e37F);
  std::vector<float> got(kCount, -1.0F);
  use.times_exp2_quick(amplitude.data(), x.data(), kCount, got.data());
  for (const float v : got) ASSERT_TRUE(v >= 0 && v < 1e-38F) << v;
}

TEST_P(Elementary, ExponentialOfDoubles) {
  auto x = powers(-40, 9.9, 5);
  for (double& v : x) v = -v;
  const auto amplitude = powers(-10, 40, 15);
  use.times_exp2_exact(amplitude.data(), x.data(), kCount, out.data());
  const auto truth = [&](std::size_t i) {
    return static_cast<long double>(amplitude[i]) * std::exp2(static_cast<long double>(x[i]));
  };
  EXPECT_LE(worst_relative(out, truth), errors::kExactTimesExp2Error);
}

TEST_P(Elementary, Angle) {
  const auto y = powers(-30, 30, 6), x = powers(-30, 30, 7);
  const auto worst = [&]() -> long double {
    long double error = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
      const long double want = std::atan2(static_cast<long double>(y[i]), x[i]);
      if (std::isnan(out[i])) return HUGE_VALL;
      error = std::max(error, std::fabs(out[i] - want));
    }
    return error;
  };
  use.angle_quick(y.data(), x.data(), kCount, out.data());
  EXPECT_LE(worst(), errors::kQuickAngleError);
  use.angle_exact(y.data(), x.data(), kCount, out.data());
  EXPECT_LE(worst(), errors::kExactAngleError);
}

TEST_P(Elementary, QuickDivision) {
  const auto a = powers(-300, 300, 8), b = powers(-300, 300, 9);
  use.divide_quick(a.data(), b.data(), kCount, out.data());
  EXPECT_LE(
      worst_relative(out, [&](std::size_t i) { return a[i] / static_cast<long double>(b[i]); }),
      errors::kQuickDivisionError);
}

TEST_P(Elementary, ProductAndWhatRoundingTookFromIt) {
  const auto a = powers(-200, 200, 10), b = powers(-200, 200, 11);
  std::vector<double> lost(kCount);
  use.product(a.data(), b.data(), kCount, out.data(), lost.data());
  for (std::size_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(out[i], a[i] * b[i]) << a[i] << " * " << b[i];
    ASSERT_EQ(lost[i], std::fma(a[i], b[i], -out[i])) << a[i] << " * " << b[i];
  }
}

TEST_P(Elementary, DotOfVectorsThatCancels) {
  const auto worst = [&](const testing::VectorPairs& pairs) {
    return worst_relative(out, [&](std::size_t i) { return pairs.truth[i]; });
  };
  const auto narrow = testing::cancelling_pairs<float>(kCount, 12);
  use.dot_quick(narrow.a.data(), narrow.b.data(), kCount, out.data());
  EXPECT_LE(worst(narrow), errors::kExactDotError);
  const auto wide = testing::cancelling_pairs<double>(kCount, 13);
  use.dot_exact(wide.a.data(), wide.b.data(), kCount, out.data());
  EXPECT_LE(worst(wide), errors::kExactDotError);
}

INSTANTIATE_TEST_SUITE_P(EachIsa, Elementary, ::testing::ValuesIn(supported_isas()),
                         [](const auto& at) { return std::string(name_of(at.param)); });

}  // namespace
}  // namespace gonio::testing
