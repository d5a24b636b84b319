#include "engine/random_numbers.h"

#include <array>

namespace gonio {
namespace {

using Words = std::array<std::uint32_t, 3>;

// Salmon et al. 2011, figure 2: ten rounds of Philox4x32; the first three of its four words.
Words philox(std::uint64_t counter, std::uint64_t key) {
  constexpr std::uint64_t kFirst = 0xD2511F53, kSecond = 0xCD9E8D57;
  std::uint32_t x0 = static_cast<std::uint32_t>(counter),
                x1 = static_cast<std::uint32_t>(counter >> 32), x2 = 0, x3 = 0;
  auto k0 = static_cast<std::uint32_t>(key), k1 = static_cast<std::uint32_t>(key >> 32);
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = kFirst * x0, b = kSecond * x2;
    const auto a_high = static_cast<std::uint32_t>(a >> 32);
    x0 = static_cast<std::uint32_t>(b >> 32) ^ x1 ^ k0;
    x2 = a_high ^ x3 ^ k1;
    x1 = static_cast<std::uint32_t>(b);
    x3 = static_cast<std::uint32_t>(a);
    k0 += 0x9E3779B9, k1 += 0xBB67AE85;
  }
  return {x0, x1, x2};
}

std::uint32_t reversed(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00) >> 8) | ((x & 0x00ff00ff) << 8);
  x = ((x & 0xf0f0f0f0) >> 4) | ((x & 0x0f0f0f0f) << 4);
  x = ((x & 0xcccccccc) >> 2) | ((x & 0x33333333) << 2);
  return ((x & 0xaaaaaaaa) >> 1) | ((x & 0x55555555) << 1);
}

// Direction numbers of the second and third dimension, by the recurrences of their primitive
// polynomials x + 1 and x^2 + x + 1.
struct Directions32 {
  std::array<std::uint32_t, 32> second, third;
};
constexpr Directions32 directions() {
  Directions32 d{};
  std::array<std::uint32_t, 32> m2{}, m3{};
  m2[0] = 1, m3[0] = 1, m3[1] = 3;
  for (std::size_t i = 1; i < 32; ++i) m2[i] = (2 * m2[i - 1]) ^ m2[i - 1];
  for (std::size_t i = 2; i < 32; ++i) m3[i] = (2 * m3[i - 1]) ^ (4 * m3[i - 2]) ^ m3[i - 2];
  for (std::size_t i = 0; i < 32; ++i) {
    d.second[i] = m2[i] << (31 - i);
    d.third[i] = m3[i] << (31 - i);
  }
  return d;
}

std::uint32_t sobol(std::uint32_t index, const std::array<std::uint32_t, 32>& direction) {
  std::uint32_t x = 0;
  for (std::size_t bit = 0; index != 0; ++bit, index >>= 1) x ^= (index & 1U) * direction[bit];
  return x;
}

// Burley 2020, section 3: a permutation of the numbers that keeps each bit's dependence on higher
// ones only, after reversing.
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
  x = reversed(x);
  x ^= x * 0x3d20adea;
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * 0x05526c56;
  x ^= x * 0x53a22864;
  return reversed(x);
}

Words sobol_numbers(std::uint64_t wi, std::uint64_t index, std::uint64_t seed) {
  static constexpr Directions32 kDirections = directions();
  // Other numbers than `random` draws: the high half of the counter's range.
  const Words seeds = philox(~wi, seed);
  const auto i = static_cast<std::uint32_t>(index);
  // The direction gets the first two dimensions, whose pairs are the most evenly spread.
  return {scrambled(sobol(i, kDirections.third), seeds[0]), scrambled(reversed(i), seeds[1]),
          scrambled(sobol(i, kDirections.second), seeds[2])};
}

float in_unit(std::uint32_t word, float) { return static_cast<float>(word >> 8) * 0x1p-24F; }
double in_unit(std::uint32_t word, double) { return word * 0x1p-32; }

template <class T>
void fill(const NumberSource& source, std::uint64_t first, std::uint64_t per_wi, std::size_t count,
          T* const (&xi)[3]) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t sample = first + i;
    const Words words = source.sequence == Sequence::random
                            ? philox(sample, source.seed)
                            : sobol_numbers(sample / per_wi, sample % per_wi, source.seed);
    for (std::size_t k = 0; k < 3; ++k) xi[k][i] = in_unit(words[k], T());
  }
}

}  // namespace

void random_numbers(const NumberSource& source, std::uint64_t first, std::uint64_t per_wi,
                    std::size_t count, float* const (&xi)[3]) {
  fill(source, first, per_wi, count, xi);
}
void random_numbers(const NumberSource& source, std::uint64_t first, std::uint64_t per_wi,
                    std::size_t count, double* const (&xi)[3]) {
  fill(source, first, per_wi, count, xi);
}

}  // namespace gonio
