// The error of a material as seen in a rendered picture.
#pragma once

#include "fit/data/data.h"
#include "gonio/engine/material.h"
#include "select/error/interval.h"

namespace gonio::select {

// The mean colour difference (delta_e of colour.h) of a picture of a sphere seen from afar, lit as
// the pairs say: a pair counts by its weight and the cosine of wo, as pixels show the sphere; its
// colour is pi f cos(theta_i), with which a white diffuser that faces the light is white. Three
// channels are linear sRGB, one is grey.
Ratio picture_error(const Material& material, const fit::Data& data);

}  // namespace gonio::select
