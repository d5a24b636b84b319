// Random numbers of one instruction set.
#pragma once

#include "gonio/engine/random_numbers.h"
#include "numeric/number_sequences.h"

namespace gonio::GONIO_ISA {

GONIO_INLINE float in_unit(std::uint32_t word, float) {
  return static_cast<float>(word >> 8) * 0x1p-24F;
}
GONIO_INLINE double in_unit(std::uint32_t word, double) { return word * 0x1p-32; }

// Samples up to the end of a wi, or of a run.
GONIO_INLINE void sobol_run(const NumberSource& source, std::uint64_t wi, std::uint64_t index,
                            std::size_t count, NumberRun& run) {
  // Other counters than `random` has: the high half of their range.
  NumberRun seeds;
  philox(~wi, source.seed, seeds);
  const auto first = static_cast<std::uint32_t>(index);
  // Of the largest index; all, where the count's overflow starts anew.
  const std::uint64_t largest = std::uint64_t{first} + count - 1;
  const std::size_t bits =
      largest >> 32 != 0 ? 32 : static_cast<std::size_t>(64 - __builtin_clzll(largest | 1));
  sobol_points(first, bits, {seeds.word[0][0], seeds.word[1][0], seeds.word[2][0]}, run);
}

template <class T>
void random_numbers(const NumberSource& source, std::uint64_t first, std::uint64_t per_wi,
                    std::size_t count, T* const (&xi)[3]) {
  NumberRun run;
  const bool random = source.sequence == Sequence::random;
  std::uint64_t wi = random ? 0 : first / per_wi, index = random ? 0 : first % per_wi;
  for (std::size_t done = 0, n = 0; done < count; done += n) {
    n = count - done < kNumbersAtOnce ? count - done : kNumbersAtOnce;
    if (random) {
      philox(first + done, source.seed, run);
    } else {
      if (index == per_wi) ++wi, index = 0;
      if (per_wi - index < n) n = static_cast<std::size_t>(per_wi - index);
      sobol_run(source, wi, index, n, run);
      index += n;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < n; ++i) xi[k][done + i] = in_unit(run.word[k][i], T());
    }
  }
}

}  // namespace gonio::GONIO_ISA
