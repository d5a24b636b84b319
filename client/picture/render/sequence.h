// The numbers that samples are drawn with: the first three dimensions of Sobol's sequence,
// Owen-scrambled per pixel. Whatever asks for (seed, pixel, sample, purpose) gets the same numbers,
// in any order and on any thread. Sources: Owen 1995, Randomly Permuted (t,m,s)-Nets; Burley 2020,
// Practical Hash-based Owen Scrambling, JCGT 9(4), listings 1 to 4, with Laine & Karras' 2011 hash.
// Thread safety: const.
#pragma once

#include <array>
#include <cstdint>

namespace gonio::render {

using Xi = std::array<double, 2>;  // in [0, 1)

class Sequence {
 public:
  Sequence(std::uint32_t seed, std::uint32_t pixel) : key_(mixed(seed ^ mixed(pixel))) {}

  // `purpose`: what the numbers are for; those of two purposes are independent of each other.
  [[nodiscard]] Xi draw(std::uint32_t sample, std::uint32_t purpose) const {
    const Point point = point_of(sample, purpose);
    return {unit(scrambled(reversed(point.index), mixed(point.key ^ 0x5555U))),
            unit(scrambled(sobol_second(point.index), mixed(point.key ^ 0xaaaaU)))};
  }
  // The number that goes with that pair.
  [[nodiscard]] double draw_third(std::uint32_t sample, std::uint32_t purpose) const {
    const Point point = point_of(sample, purpose);
    return unit(scrambled(sobol_third(point.index), mixed(point.key ^ 0x3333U)));
  }

 private:
  struct Point {
    std::uint32_t key, index;
  };
  [[nodiscard]] Point point_of(std::uint32_t sample, std::uint32_t purpose) const {
    const std::uint32_t key = mixed(key_ ^ mixed(purpose + 1));
    // The order is shuffled too, so that one purpose's n-th point says nothing of another's.
    return {key, scrambled(sample, key)};
  }
  // A hash of 32 bits: lowbias32 of C. Wellons' search for integer hashes of little bias.
  static constexpr std::uint32_t mixed(std::uint32_t x) {
    x = (x ^ (x >> 16U)) * 0x7feb352dU;
    x = (x ^ (x >> 15U)) * 0x846ca68bU;
    return x ^ (x >> 16U);
  }
  static constexpr std::uint32_t reversed(std::uint32_t x) {
    x = ((x >> 1U) & 0x55555555U) | ((x & 0x55555555U) << 1U);
    x = ((x >> 2U) & 0x33333333U) | ((x & 0x33333333U) << 2U);
    x = ((x >> 4U) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4U);
    return __builtin_bswap32(x);
  }
  // Each bit is flipped or not by those above it.
  static constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t key) {
    x = reversed(x) + key;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return reversed(x);
  }
  static constexpr std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t column = 1U << 31U; index != 0; index >>= 1U, column ^= column >> 1U) {
      if ((index & 1U) != 0) result ^= column;
    }
    return result;
  }
  // Direction numbers by the recurrence of x^2 + x + 1 from 1 and 3.
  static constexpr std::uint32_t sobol_third(std::uint32_t index) {
    std::uint32_t result = 0, older = 1, newer = 3;
    for (std::uint32_t bit = 0; index != 0; index >>= 1U, ++bit) {
      if ((index & 1U) != 0) result ^= older << (31U - bit);
      const std::uint32_t next = (newer << 1U) ^ (older << 2U) ^ older;
      older = newer;
      newer = next;
    }
    return result;
  }
  static constexpr double unit(std::uint32_t bits) { return bits * 0x1p-32; }

  std::uint32_t key_;
};

}  // namespace gonio::render
