// Rounding of a material's numbers to few decimal digits.
#pragma once

#include "gonio/engine/material.h"

namespace gonio::select {

inline constexpr int kFewestDigits = 2, kMostDigits = 9;

// Rounds every number to so many significant decimal digits, within the bounds of its model's
// table.
MaterialSpec rounded(const MaterialSpec& spec, int digits);

}  // namespace gonio::select
