// How much of what a table says of light from one direction it has not measured. Thread safety: a
// function without state.
#pragma once

#include <array>

#include "gonio/engine/isa.h"
#include "gonio/engine/material.h"

namespace gonio {

bool has_table(const Material& material);

// The part of the hemisphere of wo, weighed by cos(theta_o), whose values are taken from holes or
// are not known at all, by 1024 directions. 0 for a material without a table and for a wi that
// cannot be evaluated.
double hole_share(const Material& material, const std::array<double, 3>& wi, Isa isa);

}  // namespace gonio
