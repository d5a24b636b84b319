#include "fit/bounds/colour.h"

#include <algorithm>

#include "gonio/models/description.h"

namespace gonio::fit {
namespace {

constexpr std::array<ColourMember, 1> kDiffuse{&Colour::diffuse};
constexpr std::array<ColourMember, 3> kLobe{&Colour::scale, &Colour::reflectance, &Colour::diffuse};

// A parameter's bounds; 0 and 1 where the lobe has none.
struct Interval {
  double lower = 0, upper = 1;
};
Interval interval_of(const Parameter* p) {
  return p == nullptr ? Interval{} : Interval{p->lower, p->upper};
}

}  // namespace

std::span<const ColourMember> LobeColours::members() const {
  if (is_diffuse(columns)) return kDiffuse;
  if (columns == Columns::affine_over_base) return kLobe;
  return std::span(kLobe).first(columns == Columns::affine ? 2 : 1);
}

const Parameter& LobeColours::parameter(ColourMember member) const {
  if (member == &Colour::diffuse) return *diffuse;
  return member == &Colour::scale ? *scale : *reflectance;
}

ColourBounds LobeColours::bounds() const {
  const Interval of_scale = interval_of(scale), of_reflectance = interval_of(reflectance),
                 of_diffuse = interval_of(diffuse);
  ColourBounds bounds{{of_scale.lower, of_reflectance.lower, of_diffuse.lower},
                      {of_scale.upper, of_reflectance.upper, of_diffuse.upper}};
  if (columns != Columns::scaled || reflectance == nullptr) return bounds;
  bounds.lower.scale *= of_reflectance.lower;
  bounds.upper.scale *= of_reflectance.upper;
  return bounds;
}

Colour colour_of(Columns columns, std::span<const double> coefficients) {
  const auto& x = coefficients;
  if (is_diffuse(columns)) return {0, 0, x[0]};
  if (columns == Columns::scaled) return {x[0], 0, 0};
  Colour colour;
  colour.scale = x[0] + x[1];
  colour.reflectance = colour.scale > 0 ? x[0] / colour.scale : 0;
  const double rest = 1 - colour.reflectance;
  if (x.size() > 2 && x[2] > 0) colour.diffuse = x[2] / std::max(rest, 1e-300);
  return colour;
}

std::array<double, 3> coefficients_of(Columns columns, const Colour& colour) {
  if (is_diffuse(columns)) return {colour.diffuse, 0, 0};
  if (columns == Columns::scaled) return {colour.scale, 0, 0};
  const double rest = 1 - colour.reflectance;
  return {colour.scale * colour.reflectance, colour.scale * rest, colour.diffuse * rest};
}

std::array<double, 3> slopes_of(Columns columns, const Colour& colour, ColourMember member) {
  if (is_diffuse(columns) || columns == Columns::scaled) return {1, 0, 0};
  if (member == &Colour::scale) return {colour.reflectance, 1 - colour.reflectance, 0};
  if (member == &Colour::reflectance) return {colour.scale, -colour.scale, -colour.diffuse};
  return {0, 0, 1 - colour.reflectance};
}

}  // namespace gonio::fit
