// The bounds of the models' tables that hold an optimum.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/bounds/coordinates.h"
#include "fit/form.h"

namespace gonio::fit {

// A shape in search scale so near to a bound is at it, and so is a colour by that part of its
// bound: what descents leave.
inline constexpr double kAtBound = 1e-9;

// What is at a bound but for rounding: fields with the side, "specular[0].parameters.scale
// (upper)", each once. `nothing`: the height of a column, in the form's unit, that the data cannot
// see.
std::vector<std::string> active_bounds(const Form& form, std::span<const double> parameters,
                                       int channels, double nothing);

// Those of the coordinates that are inside their bounds.
std::vector<std::size_t> inside_bounds(const Form& form, std::span<const double> coordinates,
                                       const Bounds& bounds, double nothing);

}  // namespace gonio::fit
