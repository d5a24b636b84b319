// Arrays' functions on every instruction set, against the standard library's and objective.h.
#include "fit/linear/array_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "gonio/engine/isa.h"

namespace gonio::testing {
namespace {

const fit::ArrayKernels& kernels_of(Isa isa) {
  if (isa == Isa::avx512) return avx512::kArrayKernels;
  return isa == Isa::avx2 ? avx2::kArrayKernels : baseline::kArrayKernels;
}

// Even in their logarithms, with 0.
std::vector<double> numbers(std::size_t count, double low, double high) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform;
  std::vector<double> x{0};
  while (x.size() < count) x.push_back(low * std::pow(high / low, uniform(random)));
  return x;
}

TEST(ArrayKernels, Log1p) {
  auto x = numbers(20'003, 1e-20, 1e30);
  for (std::size_t i = 0; i < 1000; ++i) x.push_back(-4e-4 * static_cast<double>(i));
  std::vector<double> got(x.size());
  for (const Isa isa : supported_isas()) {
    kernels_of(isa).log_1p(x.data(), x.size(), got.data());
    for (std::size_t i = 0; i < x.size(); ++i)
      ASSERT_NEAR(got[i], std::log1p(x[i]), 2e-15 * std::abs(std::log1p(x[i])) + 2e-16) << x[i];
  }
}

TEST(ArrayKernels, CubeRoot) {
  const auto x = numbers(20'003, 1.6e-30, 1e38);
  std::vector<double> got(x.size());
  for (const Isa isa : supported_isas()) {
    kernels_of(isa).cube_root(x.data(), x.size(), got.data());
    EXPECT_NEAR(got[0], 1.2e-10, 1e-11);
    for (std::size_t i = 1; i < x.size(); ++i)
      ASSERT_NEAR(got[i] / std::cbrt(x[i]), 1, 1e-15) << x[i];
  }
}

// Any length, no more is written than that, and what a place holds does not depend on it.
TEST(ArrayKernels, TakeAnyLength) {
  const auto x = numbers(40, 1e-3, 1e3);
  for (const Isa isa : supported_isas()) {
    std::vector<double> whole(x.size());
    kernels_of(isa).cube_root(x.data(), x.size(), whole.data());
    for (std::size_t count = 0; count < x.size(); ++count) {
      std::vector<double> some(x.size(), -1);
      kernels_of(isa).cube_root(x.data(), count, some.data());
      for (std::size_t i = 0; i < x.size(); ++i) ASSERT_EQ(some[i], i < count ? whole[i] : -1);
    }
  }
}

void expect_residuals(const fit::ArrayKernels& kernels, const fit::Loss& loss, std::size_t count) {
  auto f = numbers(count, 1e-4, 1e2), m = numbers(count, 1e-4, 1e2);
  m[0] = 0.5;
  std::vector<double> cosine(count, 0.7), weight(count, 0.3), e(count), slope(count), root(count);
  for (double& x : m) x = loss.transformed(x * 1.3);
  const double sum = kernels.residuals[static_cast<std::size_t>(loss.objective)](
      {count, f.data(), cosine.data(), weight.data(), m.data(), loss.smooth, loss.threshold,
       e.data(), slope.data(), root.data()});
  double expected = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double truth = loss.transformed(0.7 * f[i]) - m[i];
    const double step = 1e-5 * f[i];
    const double slope_here =
        (loss.transformed(0.7 * (f[i] + step)) - loss.transformed(0.7 * (f[i] - step))) /
        (2 * step);
    expected += 0.3 * loss.loss(truth);
    EXPECT_NEAR(e[i], truth, 2e-10 + 1e-14 * std::abs(truth));
    EXPECT_NEAR(root[i] * root[i], 0.3 * loss.weight(truth), 1e-8 * loss.weight(truth));
    if (f[i] > 0) {
      EXPECT_NEAR(slope[i] / slope_here, 1, 1e-8);
    }
  }
  EXPECT_NEAR(sum / expected, 1, 1e-9) << name_of(loss.objective);
}

TEST(ArrayKernels, ResidualsAreThoseOfTheLoss) {
  for (const Isa isa : supported_isas()) {
    for (int objective = 0; objective < fit::kObjectiveCount; ++objective) {
      for (const std::size_t count : {1U, 15U, 16U, 500U})
        expect_residuals(kernels_of(isa), {static_cast<fit::Objective>(objective), 0.02, 0.4},
                         count);
    }
  }
}

}  // namespace
}  // namespace gonio::testing
