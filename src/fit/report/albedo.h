// How much of the light that comes in at an angle a material sends back.
#pragma once

#include <vector>

#include "gonio/engine/material.h"

namespace gonio::fit {

// The integral of f(wi, wo) cos(theta_o) over the hemisphere, a number a channel, for wi at `theta`
// (radians) in the plane of u. To about a thousandth for lobes wider than a thousandth of a radian.
std::vector<double> directional_albedo(const Material& material, double theta);

}  // namespace gonio::fit
