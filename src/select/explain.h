// Why a material is not good enough, in words.
#pragma once

#include <string>

#include "fit/data/data.h"
#include "gonio/engine/material.h"
#include "select/scene.h"

namespace gonio::select {

// The error over `data`, the angle up to which the material would do, the angles at which most of
// the error arises, and whether it is about the mirror direction or toward the light.
std::string explain_miss(const Material& material, const fit::Data& data, const Scene& scene);

}  // namespace gonio::select
