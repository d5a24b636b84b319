// Colours for values. Thread safety: no state.
#pragma once

#include "client/picture/lobe/canvas.h"

namespace gonio::lobe {

// From dark violet (0) to pale yellow (1), evenly darker to lighter for every eye: ten points of
// "inferno" (S. van der Walt and N. Smith, public domain), joined by straight lines.
Colour false_colour(double position);

}  // namespace gonio::lobe
