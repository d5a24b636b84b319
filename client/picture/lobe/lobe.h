// What a material reflects of light from one direction. Thread safety: plain values.
#pragma once

#include <vector>

#include "client/picture/render/evaluator.h"
#include "gonio/base/result.h"

namespace gonio::lobe {

// Angles in degrees. phi_i is the azimuth of wi, from u towards v.
struct Incidence {
  double theta_i = 0, phi_i = 0;
  bool cosine = false;  // f cos(theta_o) in place of f
};

// In the plane of incidence. theta_o from -90 to 90, in degrees: negative on the side of the light.
// It is sampled every tenth of a degree, and finer near the mirror's direction, where a polished
// surface's lobe may be a thousandth of a degree wide.
struct Curve {
  std::vector<double> theta_o;
  std::vector<image::Rgb> values;
};

// These angles.
std::vector<double> angles_around(double mirror);

Result<Curve> curve_of(const Incidence& incidence, render::Evaluator& evaluator);

// The hemisphere as seen from above, the mirror's direction to the right: a square of side x side
// pixels around it, each the mean of four values; 0 outside.
Result<std::vector<image::Rgb>> hemisphere_of(const Incidence& incidence, int side,
                                              render::Evaluator& evaluator);

}  // namespace gonio::lobe
