// The picture of a material's lobes: for each angle of incidence a polar plot in the plane of
// incidence above a map of the hemisphere, all on one scale. Thread safety: no state.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/picture/lobe/scale.h"
#include "client/picture/render/evaluator.h"
#include "gonio/base/result.h"

namespace gonio::lobe {

struct PictureOptions {
  int width = 0, height = 0;
  std::string title;
  std::vector<double> theta_i;  // degrees, each in [0, 90)
  double phi_i = 180;           // degrees
  bool cosine = false;          // f cos(theta_o) in place of f
  ScaleKind scale = ScaleKind::log;
};

// Three bytes a pixel (sRGB), row by row. Errors: what the service or cairo says.
Result<std::vector<std::uint8_t>> draw_lobes(const PictureOptions& options,
                                             render::Evaluator& evaluator);

}  // namespace gonio::lobe
