// What is wrong with a direction.
#pragma once

#include <cstdint>

#include "gonio/engine/evaluate.h"
#include "numeric/inline.h"
#include "parts/geometry.h"

namespace gonio {

// The flags of one direction. `below` is the flag for a direction at or below the horizon.
GONIO_INLINE std::uint8_t direction_flags(double x, double y, double z, std::uint8_t below) {
  if (!(x - x == 0 && y - y == 0 && z - z == 0)) return flag::not_finite;  // NaN and infinity alike
  if (x == 0 && y == 0 && z == 0) return flag::zero;
  constexpr double kLow = (1 - kLengthTolerance) * (1 - kLengthTolerance);
  constexpr double kHigh = (1 + kLengthTolerance) * (1 + kLengthTolerance);
  const double length2 = x * x + y * y + z * z;
  std::uint8_t flags = 0;
  if (!(length2 > kLow && length2 < kHigh)) flags |= flag::not_unit;
  if (!(z > 0)) flags |= below;
  return flags;
}

}  // namespace gonio
