// Arrays of arguments for the tests of elementary functions, and how wrong results are.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

#include "gonio/engine/isa.h"
#include "numeric/functions.h"

namespace gonio::testing {

inline constexpr std::size_t kCount = 1 << 16;

inline const Functions& functions(Isa isa) {
  switch (isa) {
    case Isa::avx512:
      return avx512::kFunctions;
    case Isa::avx2:
      return avx2::kFunctions;
    default:
      return baseline::kFunctions;
  }
}

// 2^(a uniform exponent between `low` and `high`).
inline std::vector<double> powers(double low, double high, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> exponent(low, high);
  std::vector<double> all(kCount);
  for (double& x : all) x = std::exp2(exponent(random));
  return all;
}

template <class Number>
long double worst_relative(const std::vector<Number>& got,
                           const std::function<long double(std::size_t)>& truth) {
  long double worst = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const long double want = truth(i);
    const long double error = std::fabs(static_cast<long double>(got[i]) - want) / std::fabs(want);
    if (std::isnan(error)) return HUGE_VALL;
    worst = std::max(worst, error);
  }
  return worst;
}

}  // namespace gonio::testing
