// How far a material is from measured data, by every measure that the field uses, and by zone of
// angles: norms that do not weigh by cosines are ruled by what lies next to the horizon.
#pragma once

#include <cstddef>
#include <vector>

#include "fit/data/data.h"
#include "gonio/engine/material.h"
#include "gonio/fit/certificate.h"

namespace gonio::fit {

inline constexpr double kGrazing = 1.3962634015954636;  // 80 degrees, in radians

struct Comparison {
  ErrorsByZone errors;
  Regions regions;
  std::vector<Place> worst;  // the worst first
};

// `worst` is how many places are wanted, no two within `apart` radians of each other in both
// directions. Channels must agree; a material of one channel stands for all.
Comparison compare(const Material& material, const Data& data, std::size_t worst = 5);

}  // namespace gonio::fit
