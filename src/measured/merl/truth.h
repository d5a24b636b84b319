// What a table says of a pair, in long double: the cells that the kernels look up, summed.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "measured/merl/lookup.h"
#include "numeric/extended.h"
#include "parts/geometry.h"

namespace gonio::merl {

// Whether a position is so near to a cell's edge that float32's rounding decides between cells.
inline bool at_an_edge(const TablePosition<Extended>& at) {
  constexpr long double kNear = 1e-3L;
  const auto near = [](LongDouble x) { return std::abs(x.v - std::round(x.v)) < kNear; };
  return near(at.h) || near(at.d) || near(at.p);
}

// Next to h = n or wi = wo, and not at it, the azimuth that a table is read at is a matter of
// rounding.
inline bool has_no_azimuth(const Geometry<Extended>& pair) {
  constexpr long double kNear = 1e-8L;  // of squared sines
  const Vec3<LongDouble>&h = pair.half.h, d = pair.wi - pair.wo;
  const long double across = h.x.v * h.x.v + h.y.v * h.y.v, apart = dot(d, d).v;
  return (across > 0 && across < kNear * h.z.v * h.z.v) ||
         (apart > 0 && apart < kNear * dot(h, h).v);
}

template <int kCorners>
void add_cells(const float* table, const Geometry<Extended>& pair, std::span<long double> f,
               std::span<long double> scale) {
  const TablePosition<Extended> at = locate(pair);
  Corner<Extended> corner[kCorners];
  find_corners(at, corner);
  const bool unsure = (kCorners == 1 && at_an_edge(at)) || has_no_azimuth(pair);
  for (std::size_t c = 0; c < f.size(); ++c) {
    long double total = 0, sum = 0, largest = 0;
    for (const auto& k : corner) {
      const auto channel = static_cast<int>(c);
      const LongDouble value = fetch<Extended>(table, k.index, channel);
      if (!(value.v > -1)) continue;  // NaN: not measured
      total += k.weight.v;
      sum += k.weight.v * value.v;
      largest = std::max(largest, value.v);
    }
    f[c] += total > 0 ? sum / total : 0;
    if (!scale.empty())
      scale[c] += unsure ? std::numeric_limits<long double>::quiet_NaN() : largest;
  }
}

}  // namespace gonio::merl
