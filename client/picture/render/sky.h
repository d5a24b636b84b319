// A hazy sky whose sun is behind thin clouds, above grey ground. Thread safety: no state.
#pragma once

#include "client/picture/image/image.h"

namespace gonio::render {

// A map for dome_light(). With s the sine of the elevation and c the cosine to the hidden sun (45
// degrees high, from the left behind the camera), in each of red, green, blue:
//   s > 0:  L = horizon + (zenith - horizon) sqrt(s) + glow exp(30 (c - 1))
//   else:   L = haze + (ground - haze) sqrt(-s)
//   horizon = (0.95, 0.95, 0.93), zenith = (0.12, 0.24, 0.55), glow = (7.0, 6.2, 5.0),
//   haze = (0.33, 0.31, 0.29), ground = (0.10, 0.09, 0.08)
// A formula of our own, chosen for what it shows: an edge and a soft highlight in which a
// material's sharpness and direction can be read. Nothing in it is as bright as a sun.
image::Image sky_map();

}  // namespace gonio::render
