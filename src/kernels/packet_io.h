// Loading packets of directions, and saying what is wrong with the pairs that cannot be evaluated.
#pragma once

#include "gonio/engine/evaluate.h"
#include "kernels/direction_flags.h"
#include "kernels/kernel.h"
#include "numeric/number.h"
#include "parts/geometry.h"

namespace gonio::GONIO_ISA {

template <class T, class In>
GONIO_INLINE Vec3<T> load(const In* const (&component)[3], std::size_t i) {
  return {T::load(component[0] + i), T::load(component[1] + i), T::load(component[2] + i)};
}

// Large batches come from memory in six streams and go back in three or more: more than the
// processor foresees. The distances, in numbers, are what ran fastest.
constexpr std::size_t kAheadOfReading = 256, kAheadOfWriting = 512;

// The triples of a packet in the next run: one run is computed with before the next is read, and
// the processor has forgotten where it was.
constexpr std::size_t kAheadInTriples = 256;
GONIO_INLINE void fetch_ahead(const float* xyz) {
  for (std::size_t c = 0; c < 3; ++c)
    __builtin_prefetch(xyz + 3 * kAheadInTriples + c * raw::kWidth);
}

template <class N, class In>
GONIO_INLINE Geometry<N> load_geometry(const KernelInput<In>& in, std::size_t i) {
  for (int c = 0; c < 3; ++c) {
    __builtin_prefetch(in.wi[c] + i + kAheadOfReading);
    __builtin_prefetch(in.wo[c] + i + kAheadOfReading);
  }
  return {load<typename N::Wide>(in.wi, i), load<typename N::Wide>(in.wo, i),
          load<typename N::Real>(in.wi, i), load<typename N::Real>(in.wo, i)};
}

// The rare path: flags of the lanes that are not valid.
template <class In>
[[gnu::noinline]] void note_flags(const KernelInput<In>& in, std::size_t i, unsigned valid,
                                  std::uint8_t* flags) {
  if (flags == nullptr) return;
  for (std::size_t lane = 0; lane < raw::kWidth; ++lane) {
    if ((valid >> lane & 1U) != 0) continue;
    const std::size_t at = i + lane;
    const auto found = static_cast<std::uint8_t>(
        direction_flags(in.wi[0][at], in.wi[1][at], in.wi[2][at], flag::incident_below_horizon) |
        direction_flags(in.wo[0][at], in.wo[1][at], in.wo[2][at], flag::outgoing_below_horizon));
    // A length within rounding of the tolerance may look right here and wrong to the kernel, whose
    // word counts.
    flags[at] = found != 0 ? found : flag::not_unit;
  }
}

}  // namespace gonio::GONIO_ISA
