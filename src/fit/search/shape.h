// A parameter that all channels share: where it may be, where a scan looks for it, and in what
// scale.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "gonio/models/description.h"

namespace gonio::fit {

// The scale in which a shape parameter is searched: p = offset + exp(u), or p = u.
struct SearchScale {
  bool logarithmic = false;
  double offset = 0;
  [[nodiscard]] double to_parameter(double u) const;
  [[nodiscard]] double to_search(double p) const;
  [[nodiscard]] double slope(double u) const;  // dp/du
};

struct ShapeParameter {
  std::size_t lobe;  // whose parameter it is
  Quantity quantity;
  std::vector<std::string> names;  // one, or two that are held equal (alpha_x and alpha_y)
  std::string field;               // as errors name it, e.g. "specular[0].parameters.m"
  SearchScale scale;
  double lower, upper, start;     // of the parameter, as the model's table has them
  double scan_lower, scan_upper;  // where a scan looks
  std::optional<double> guess;    // the caller's
};

// As the model's table has it; lobe, field and guess are the form's to fill in. `dielectric`: a
// refractive index is that of one.
ShapeParameter shape_of(const Parameter& p, Quantity quantity, bool dielectric);

// Does it say how wide a lobe is? That changes f most; Fresnel and shares are gentle.
bool is_width(const ShapeParameter& shape);

// The rotation of the material's tangents, in degrees; `lobe` is the first that has any. Each
// quarter of a turn, with the parameters along u and v swapped, gives the same material: a scan
// looks within one.
ShapeParameter rotation_shape(std::size_t lobe);

}  // namespace gonio::fit
