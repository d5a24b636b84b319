// The catalogue of places where reflectance models fail in naive arithmetic: what is special there,
// and pairs of directions that lie there. Thread safety: constant data, functions without state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "assess/subject.h"

namespace gonio::assess {

struct HardPlace {
  std::string_view name;     // "near_mirror"
  std::string_view where;    // "h at 1e-6 to 1 rad from n"
  std::string_view failure;  // what naive arithmetic does there
};

// All of them.
std::span<const HardPlace> places();

// About `count` pairs at a place, in float64, the same for the same seed; none where the material
// has no such place. `place` is an index of places().
std::vector<Pair> pairs_at(std::size_t place, const Subject& subject, std::size_t count,
                           std::uint64_t seed);

// The same, rounded to float32.
std::vector<Pair> rounded(std::vector<Pair> pairs);

}  // namespace gonio::assess
