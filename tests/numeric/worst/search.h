// The search for a function's worst error: blocks of arguments, whose truth is computed once,
// through every instruction set.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "engine/material/flush_to_zero.h"
#include "numeric/arrays.h"

namespace gonio::testing {

using Worst = std::vector<long double>;  // one for each instruction set that is searched

// The larger one; not a number is larger than any.
inline void keep_worse(long double& worst, long double found) {
  if (!(found <= worst)) worst = std::isnan(found) ? HUGE_VALL : found;
}

// fill(block) makes kCount arguments and their truth, evaluate(functions) the results, error(i)
// their errors. Kernels flush what is too small for its type to 0, and so does the search.
template <class Fill, class Evaluate, class Error>
Worst search(std::span<const Isa> isas, std::size_t blocks, const Fill& fill,
             const Evaluate& evaluate, const Error& error) {
  Worst worst(isas.size(), 0);
  for (std::size_t block = 0; block < blocks; ++block) {
    fill(block);
    for (std::size_t k = 0; k < isas.size(); ++k) {
      const FlushToZero flush;
      evaluate(functions(isas[k]));
      for (std::size_t i = 0; i < kCount; ++i) keep_worse(worst[k], error(i));
    }
  }
  return worst;
}

template <class Number>
long double relative_error(Number got, long double truth) {
  return std::abs((static_cast<long double>(got) - truth) / truth);
}

// All float32 numbers of a binade, [2^exponent, 2^(exponent + 1)), are kBinade blocks.
inline constexpr std::size_t kBinade = (1U << 23) / kCount;

// The numbers of one block, from 2^exponent upwards over as many binades as there are blocks.
inline void fill_floats(int exponent, std::size_t block, float sign, std::vector<float>& x) {
  const auto first = static_cast<std::uint32_t>((exponent + 127) << 23) +
                     static_cast<std::uint32_t>(block * kCount);
  for (std::size_t i = 0; i < kCount; ++i)
    x[i] = sign * std::bit_cast<float>(first + static_cast<std::uint32_t>(i));
}

// Random arguments of a search in float64.
constexpr std::size_t kRandomBlocks = 64;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  double logarithmic(double low, double high) { return std::exp2(uniform(low, high)); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace gonio::testing
