// An independent reading of the MERL database's lookup, and of interpolation between its cells.
//
// The angles and the nearest cell follow the database's own reader: the incident direction is
// turned by -phi_h about the normal and by -theta_h about v. Sharing nothing with src/, in long
// double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "gonio/measured/table.h"

namespace gonio::testing {

using Real = long double;
using Direction = std::array<Real, 3>;

struct Angles {
  Real theta_h, theta_d, phi_d;  // phi_d in [0, pi)
};

inline Direction normalized(const Direction& w) {
  const Real length = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  return {w[0] / length, w[1] / length, w[2] / length};
}

inline Angles rusinkiewicz(const Direction& wi, const Direction& wo) {
  const Direction i = normalized(wi), o = normalized(wo);
  const Direction h = normalized({i[0] + o[0], i[1] + o[1], i[2] + o[2]});
  const Real theta_h = std::acos(std::min(h[2], Real(1))), phi_h = std::atan2(h[1], h[0]);
  const Real cp = std::cos(-phi_h), sp = std::sin(-phi_h);
  const Direction turned{cp * i[0] - sp * i[1], sp * i[0] + cp * i[1], i[2]};
  const Real ct = std::cos(-theta_h), st = std::sin(-theta_h);
  const Direction d{ct * turned[0] + st * turned[2], turned[1], ct * turned[2] - st * turned[0]};
  Real phi_d = std::atan2(d[1], d[0]);
  if (phi_d < 0) phi_d += std::numbers::pi_v<Real>;
  return {theta_h, std::acos(std::clamp(d[2], Real(-1), Real(1))), phi_d};
}

// Coordinates in cells: the integer part is the cell that holds the angles.
struct Position {
  Real h, d, p;
};

inline Position position(const Angles& a) {
  constexpr Real kHalfPi = std::numbers::pi_v<Real> / 2;
  return {std::sqrt(a.theta_h / kHalfPi) * 90, a.theta_d / kHalfPi * 90,
          a.phi_d / (2 * kHalfPi) * 180};
}

inline std::size_t cell_of(int h, int d, int p) {
  return (static_cast<std::size_t>(h) * 90 + static_cast<std::size_t>(d)) * 180 +
         static_cast<std::size_t>(p);
}

inline std::size_t nearest_cell(const Position& at) {
  const auto index = [](Real x, int cells) {
    return std::clamp(static_cast<int>(x), 0, cells - 1);
  };
  return cell_of(index(at.h, 90), index(at.d, 90), index(at.p, 180));
}

// How far, in cells, the position is from the nearest wall between cells.
inline Real distance_to_wall(const Position& at) {
  Real least = 1;
  for (const Real x : {at.h, at.d, at.p}) least = std::min(least, std::abs(x - std::round(x)));
  return least;
}

struct Interpolated {
  std::array<Real, 3> value{};  // 0 without a valid cell
  Real weight = 0;              // of the valid cells
  Real largest = 0;             // value among them
};

inline Interpolated interpolate(const MeasuredTable& table, const Position& at) {
  const Real h = std::clamp(at.h - Real(0.5), Real(0), Real(89));
  const Real d = std::clamp(at.d - Real(0.5), Real(0), Real(89));
  const Real p = at.p - Real(0.5);
  Interpolated result;
  for (int corner = 0; corner < 8; ++corner) {
    const auto along = [](Real x, bool upper) {
      const Real floor = std::floor(x), part = x - floor;
      return std::pair{static_cast<int>(floor) + (upper ? 1 : 0), upper ? part : 1 - part};
    };
    const auto [ih, wh] = along(h, (corner & 1) != 0);
    const auto [id, wd] = along(d, (corner & 2) != 0);
    const auto [ip, wp] = along(p, (corner & 4) != 0);
    const Real weight = wh * wd * wp;
    if (weight == 0) continue;
    const float* rgb =
        table.data() + 3 * cell_of(std::min(ih, 89), std::min(id, 89), (ip + 180) % 180);
    if (std::isnan(rgb[0])) continue;
    result.weight += weight;
    for (std::size_t c = 0; c < 3; ++c) {
      result.value[c] += weight * static_cast<Real>(rgb[c]);
      result.largest = std::max(result.largest, static_cast<Real>(rgb[c]));
    }
  }
  if (result.weight > 0) {
    for (Real& v : result.value) v /= result.weight;
  }
  return result;
}

}  // namespace gonio::testing
