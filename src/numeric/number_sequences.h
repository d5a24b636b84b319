// The integers of random numbers (engine/random_numbers.h says which), a run at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "numeric/packet.h"

namespace gonio::GONIO_ISA {

// The largest length of a run.
inline constexpr std::size_t kNumbersAtOnce = 64;
struct NumberRun {
  std::uint32_t word[3][kNumbersAtOnce];
};

// Salmon et al. 2011, figure 2: ten rounds of Philox4x32 for the counters first, first + 1, ...;
// the first three of their four words. A word is in the lower half of a 64-bit lane, whose upper
// half nothing reads.
GONIO_INLINE void philox(std::uint64_t first, std::uint64_t key, NumberRun& run) {
  constexpr std::size_t kLanes = sizeof(raw::I) / sizeof(long long);
  const raw::I m0 = raw::broadcast(0xD2511F53LL), m1 = raw::broadcast(0xCD9E8D57LL);
  static constexpr long long kOneAfterAnother[] = {0, 1, 2, 3, 4, 5, 6, 7};
  for (std::size_t begin = 0; begin < kNumbersAtOnce; begin += kLanes) {
    long long out[3][kLanes];
    const std::uint64_t counter = first + begin;
    raw::I x0 = raw::broadcast(static_cast<long long>(counter)) + raw::load(kOneAfterAnother);
    raw::I x1 = raw::high_half(x0);
    raw::I x2 = raw::broadcast(0LL), x3 = x2;
    auto k0 = static_cast<std::uint32_t>(key), k1 = static_cast<std::uint32_t>(key >> 32);
    for (int round = 0; round < 10; ++round) {
      const raw::I a = raw::multiply_low(m0, x0), b = raw::multiply_low(m1, x2);
      x0 = raw::high_half(b) ^ x1 ^ raw::broadcast(static_cast<long long>(k0));
      x2 = raw::high_half(a) ^ x3 ^ raw::broadcast(static_cast<long long>(k1));
      x1 = b;
      x3 = a;
      k0 += 0x9E3779B9, k1 += 0xBB67AE85;
    }
    raw::store(out[0], x0), raw::store(out[1], x1), raw::store(out[2], x2);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < kLanes; ++i)
        run.word[k][begin + i] = static_cast<std::uint32_t>(out[k][i]);
    }
  }
}

GONIO_INLINE std::uint32_t reversed(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00) >> 8) | ((x & 0x00ff00ff) << 8);
  x = ((x & 0xf0f0f0f0) >> 4) | ((x & 0x0f0f0f0f) << 4);
  x = ((x & 0xcccccccc) >> 2) | ((x & 0x33333333) << 2);
  return ((x & 0xaaaaaaaa) >> 1) | ((x & 0x55555555) << 1);
}

// Direction numbers of the second and third dimension, by the recurrences of their primitive
// polynomials x + 1 and x^2 + x + 1.
struct SobolDirections {
  std::uint32_t second[32], third[32];
};
constexpr SobolDirections sobol_directions() {
  SobolDirections d{};
  std::uint32_t m2[32]{}, m3[32]{};
  m2[0] = 1, m3[0] = 1, m3[1] = 3;
  for (std::size_t i = 1; i < 32; ++i) m2[i] = (2 * m2[i - 1]) ^ m2[i - 1];
  for (std::size_t i = 2; i < 32; ++i) m3[i] = (2 * m3[i - 1]) ^ (4 * m3[i - 2]) ^ m3[i - 2];
  for (std::size_t i = 0; i < 32; ++i) {
    d.second[i] = m2[i] << (31 - i);
    d.third[i] = m3[i] << (31 - i);
  }
  return d;
}

inline constexpr SobolDirections kSobol = sobol_directions();

// Burley 2020, section 3: a permutation of the numbers that keeps each bit's dependence on higher
// ones only, after reversing.
GONIO_INLINE std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
  x = reversed(x);
  x ^= x * 0x3d20adea;
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * 0x05526c56;
  x ^= x * 0x53a22864;
  return reversed(x);
}

// One dimension of the points first, first + 1, ..., of whose numbers only `bits` bits are set:
// the direction numbers of an index's bits, added without carry.
GONIO_INLINE void sobol(std::uint32_t first, std::size_t bits, const std::uint32_t (&direction)[32],
                        std::uint32_t (&x)[kNumbersAtOnce]) {
  for (std::uint32_t& word : x) word = 0;
  for (std::size_t bit = 0; bit < bits; ++bit) {
    for (std::size_t i = 0; i < kNumbersAtOnce; ++i) {
      const std::uint32_t index = first + static_cast<std::uint32_t>(i);
      x[i] ^= (0U - (index >> bit & 1U)) & direction[bit];
    }
  }
}

// Points of the sequence that belongs to three seeds. The direction gets the first two dimensions,
// whose pairs are the most evenly spread.
GONIO_INLINE void sobol_points(std::uint32_t first, std::size_t bits,
                               const std::uint32_t (&seeds)[3], NumberRun& run) {
  sobol(first, bits, kSobol.third, run.word[0]);
  sobol(first, bits, kSobol.second, run.word[2]);
  for (std::size_t i = 0; i < kNumbersAtOnce; ++i) {
    run.word[0][i] = scrambled(run.word[0][i], seeds[0]);
    run.word[1][i] = scrambled(reversed(first + static_cast<std::uint32_t>(i)), seeds[1]);
    run.word[2][i] = scrambled(run.word[2][i], seeds[2]);
  }
}

}  // namespace gonio::GONIO_ISA
