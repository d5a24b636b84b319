// Where a pair of directions falls in a measured table: Rusinkiewicz' angles, then the nearest cell
// or the eight around them. Over the number systems, as the models are.
//
// Cells are centred at i + 1/2 in the table's own coordinates (theta_h quadratically spaced). phi_d
// is periodic over half a turn, by reciprocity.
#pragma once

#include <numbers>

#include "gonio/measured/table.h"
#include "numeric/inline.h"
#include "parts/geometry.h"

namespace gonio {

// Positions on the three axes, in cells.
template <class N>
struct TablePosition {
  typename N::Wide h, d, p;
};

template <class N>
GONIO_INLINE TablePosition<N> locate(const Geometry<N>& g) {
  using Wide = typename N::Wide;
  constexpr double kPi = std::numbers::pi;
  const Vec3<Wide> h = g.half.h;
  const Vec3<Wide> d = g.wi - g.wo;
  const Wide s = sum_of_products(h.x, h.x, h.y, h.y);
  const Wide h_length = sqrt(s + h.z * h.z);
  const Wide theta_h = first_quadrant_angle(sqrt(s), h.z);
  const Wide theta_d = first_quadrant_angle(sqrt(dot(d, d)), h_length);
  // The difference in the frame of the half-vector, both components times sqrt(s) |H|. At h = n
  // that frame is the shading frame (phi_h = 0).
  const auto tilted = Wide(1e-20) < s;
  Wide x = select(tilted, sum_of_products(h.z, sum_of_products(h.x, d.x, h.y, d.y), -s, d.z), d.x);
  Wide y = select(tilted, sum_of_products(h.x, d.y, -h.y, d.x) * h_length, d.y);
  x = select(y < Wide(0), -x, x);  // half a turn on: the same value
  y = max(y, -y);
  const Wide angle = first_quadrant_angle(y, max(x, -x));
  const Wide phi_d = select(x < Wide(0), Wide(kPi) - angle, angle);
  return {sqrt(theta_h * Wide(2 / kPi)) * Wide(MeasuredTable::kThetaH),
          theta_d * Wide(2 * MeasuredTable::kThetaD / kPi),
          phi_d * Wide(MeasuredTable::kPhiD / kPi)};
}

template <class Wide>
GONIO_INLINE Wide cell_index(Wide h, Wide d, Wide p) {
  return (h * Wide(MeasuredTable::kThetaD) + d) * Wide(MeasuredTable::kPhiD) + p;
}

// A cell and its weight.
template <class N>
struct Corner {
  typename N::Wide index;
  typename N::Real weight;
};

// The corners that count at a position: one, or the eight around it.
template <class N>
GONIO_INLINE void find_corners(const TablePosition<N>& at, Corner<N> (&corner)[1]) {
  using Wide = typename N::Wide;
  const auto cell = [](Wide x, int cells) { return min(floor(x), Wide(cells - 1)); };
  corner[0] = {cell_index(cell(at.h, MeasuredTable::kThetaH), cell(at.d, MeasuredTable::kThetaD),
                          cell(at.p, MeasuredTable::kPhiD)),
               typename N::Real(1)};
}

template <class N>
GONIO_INLINE void find_corners(const TablePosition<N>& at, Corner<N> (&corner)[8]) {
  using Wide = typename N::Wide;
  using Real = typename N::Real;
  const auto clamped = [](Wide x, int cells) {
    return max(min(x - Wide(0.5), Wide(cells - 1)), Wide(0));
  };
  const Wide h = clamped(at.h, MeasuredTable::kThetaH), d = clamped(at.d, MeasuredTable::kThetaD);
  const Wide shifted = at.p - Wide(0.5);
  const Wide p = select(shifted < Wide(0), shifted + Wide(MeasuredTable::kPhiD), shifted);
  const Wide h0 = floor(h), d0 = floor(d), p0 = min(floor(p), Wide(MeasuredTable::kPhiD - 1));
  const Wide h1 = min(h0 + Wide(1), Wide(MeasuredTable::kThetaH - 1)),
             d1 = min(d0 + Wide(1), Wide(MeasuredTable::kThetaD - 1));
  const Wide p1 = select(Wide(MeasuredTable::kPhiD - 1.5) < p0, Wide(0), p0 + Wide(1));
  const Real wh = N::real(h - h0), wd = N::real(d - d0), wp = N::real(p - p0);
#pragma GCC unroll 8
  for (int i = 0; i < 8; ++i) {
    const bool far_h = (i & 4) != 0, far_d = (i & 2) != 0, far_p = (i & 1) != 0;
    corner[i] = {
        cell_index(far_h ? h1 : h0, far_d ? d1 : d0, far_p ? p1 : p0),
        (far_h ? wh : Real(1) - wh) * (far_d ? wd : Real(1) - wd) * (far_p ? wp : Real(1) - wp)};
  }
}

template <class N>
GONIO_INLINE typename N::Real fetch(const float* table, typename N::Wide cell, int channel) {
  return
      typename N::Real(gather(table + channel, cell * typename N::Wide(MeasuredTable::kChannels)));
}

}  // namespace gonio
