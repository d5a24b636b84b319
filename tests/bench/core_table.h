// What core_bench prints at the end: speed and accuracy in one table.
#pragma once

#include "bench/best.h"

namespace gonio::bench {

inline constexpr std::size_t kSizes[] = {1000, 4096, 10000, 65536, std::size_t{1} << 20};
// Where combinations are timed: 64 channels of so many pairs still fit the second-level cache. And
// what their benchmarks are called.
inline constexpr std::size_t kSpectralPairs = 1000;
inline constexpr const char* kSpectral = "/64 channels";
inline constexpr const char* kSum = "sum of four lobes";

void print_table(const Best& best);

}  // namespace gonio::bench
