// An overcast-bright sky without a sun, above grey ground. Thread safety: no state.
#pragma once

#include "client/image/image.h"

namespace gonio::render {

// A map for dome_light(). With s the sine of the elevation, in each of red, green, blue:
//   s > 0:  L = horizon + (zenith - horizon) sqrt(s),  horizon = (1.25, 1.2, 1.15),
//                                                      zenith  = (0.16, 0.32, 0.75)
//   else:   L = ground = (0.16, 0.145, 0.13)
// A formula of our own, chosen for what it shows: a bright horizon and a clear edge, in which a
// highlight's shape can be read, and an irradiance from above near pi/2.
image::Image sky_map();

}  // namespace gonio::render
