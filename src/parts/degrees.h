// From an angle in degrees to a turn about the normal (parts/rotation.h), in the numbers that
// materials are prepared in. Multiples of 90 degrees are exact.
#pragma once

#include <cmath>
#include <utility>

#include "numeric/dual.h"
#include "numeric/extended.h"
#include "parts/rotation.h"

namespace gonio {

// Of -180 to 180 degrees.
inline Rotation<LongDouble> rotation_by(LongDouble degrees) {
  constexpr long double kRadians = 0.0174532925199432957692369076848861271L;
  const long double quarters = std::nearbyint(degrees.v / 90);
  const long double rest = (degrees.v - 90 * quarters) * kRadians;
  long double cos = std::cos(rest), sin = std::sin(rest);
  for (int k = (static_cast<int>(quarters) + 4) % 4; k > 0; --k) cos = -std::exchange(sin, cos);
  return {cos, sin};
}
inline Rotation<double> rotation_by(double degrees) {
  const auto exact = rotation_by(LongDouble(degrees));
  return {static_cast<double>(exact.cos.v), static_cast<double>(exact.sin.v)};
}
inline Rotation<Dual<double>> rotation_by(const Dual<double>& degrees) {
  constexpr double kRadians = 0.017453292519943295;
  const auto at = rotation_by(degrees.v);
  const double slope = kRadians * degrees.d;
  return {{at.cos, -slope * at.sin}, {at.sin, slope * at.cos}};
}

// Whether anything turns, or would by a derivative.
inline bool is_turn(LongDouble degrees) { return degrees.v != 0; }
inline bool is_turn(double degrees) { return degrees != 0; }
inline bool is_turn(const Dual<double>& degrees) { return degrees.v != 0 || degrees.d != 0; }

}  // namespace gonio
