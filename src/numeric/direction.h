// Directions as three numbers in double precision, where no packets are needed: x, y along the
// tangents, z along the normal. Thread safety: functions without state.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace gonio {

using Direction = std::array<double, 3>;

// `theta` from the normal, `phi` from x towards y, both in radians.
inline Direction spherical(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

inline double dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Direction `i` of interleaved x, y, z.
inline Direction nth_direction(std::span<const double> xyz, std::size_t i) {
  return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
}

}  // namespace gonio
