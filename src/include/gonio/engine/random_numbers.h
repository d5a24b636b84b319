// The numbers that samples are drawn by, where the caller brings none of their own.
//
// They are functions of a seed and a sample's number and of nothing else, so that any run of a
// batch can be asked for again, from anyone, and be the same.
//
//   random   Philox4x32-10 with the seed as its key and the sample's number as its counter: Salmon,
//            Moraes, Dror & Shaw 2011, "Parallel Random Numbers: As Easy as 1, 2, 3".
//   sobol    the first three dimensions of Sobol's sequence in Joe & Kuo's directions (2008),
//            Owen-scrambled by a hash: Burley 2020, "Practical Hash-based Owen Scrambling". Each wi
//            has a scrambling of its own; its samples are evenly spread, best in powers of two.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gonio {

enum class Sequence : std::uint8_t { random, sobol };

struct NumberSource {
  Sequence sequence = Sequence::random;
  std::uint64_t seed = 0;
};

// Writes the numbers of samples first ... first + count - 1, in [0, 1): float has 24 bits, double
// 32. sobol repeats after 2^32 samples of a wi.
void random_numbers(const NumberSource& source, std::uint64_t first, std::uint64_t per_wi,
                    std::size_t count, float* const (&xi)[3]);
void random_numbers(const NumberSource& source, std::uint64_t first, std::uint64_t per_wi,
                    std::size_t count, double* const (&xi)[3]);

}  // namespace gonio
