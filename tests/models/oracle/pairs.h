// Direction pairs that are hard on a BRDF: every place where a naive formula is known to fail.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace gonio::testing {

enum class PairKind : std::uint8_t {
  hemisphere,    // both uniform
  near_mirror,   // h at every distance from n, 1e-6 to 1 rad, wi anywhere
  grazing_lobe,  // the same with wi at 80 to 89.99 degrees
  retro,         // wo within 1e-6 to 0.1 rad of wi
  grazing,       // one or both at 80 to 89.99 degrees
  exact_mirror,  // h = n exactly
  opposite,      // wo nearly -wi, both just above the horizon
  tiny_z,        // z down to the smallest positive float32
  across,        // wo at right angles to the mirror image of wi
  special,       // along the axes and the normal, h in a coordinate plane
  off_unit,      // any of the above, up to 9e-4 off unit length
};
inline constexpr std::size_t kPairKinds = 11;

std::string_view name_of(PairKind kind);

template <class T>
struct DirectionPair {
  std::array<T, 3> wi, wo;
  PairKind kind;
};

// About 13,000 pairs of all kinds, the same for the same seed; unit to the rounding of T but for
// off_unit. T is float or double.
template <class T>
std::vector<DirectionPair<T>> hard_pairs(std::uint64_t seed);

// `count` of them at random, or all there are, with both z at least `least_z`.
template <class T>
std::vector<DirectionPair<T>> some_hard_pairs(std::uint64_t seed, std::size_t count,
                                              double least_z = -1) {
  auto pairs = hard_pairs<T>(seed);
  std::erase_if(pairs, [&](const auto& p) { return std::min(p.wi[2], p.wo[2]) < least_z; });
  std::shuffle(pairs.begin(), pairs.end(), std::mt19937_64(seed));
  pairs.resize(std::min(pairs.size(), count));
  return pairs;
}

}  // namespace gonio::testing
