// Holes of a measured table: cells above the horizon that hold no measurement. They are invalid, or
// masked: much darker than what lies on both sides of them. Thread safety: a function without
// state.
#pragma once

#include <cstdint>
#include <vector>

#include "gonio/measured/table.h"

namespace gonio {

// Whether a cell with a measurement is masked: in a channel, along an axis, both sides are more
// than kMaskedBelow times as bright within three cells; of a cell that holds 0, within twelve.
inline constexpr float kMaskedBelow = 10;
bool is_masked(const float* values, int theta_h, int theta_d, int phi_d);

HoleMap holes_of(const float* values);

}  // namespace gonio
