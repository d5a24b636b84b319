#include "fit/bounds/colour.h"

#include <algorithm>

#include "gonio/models/description.h"

namespace gonio::fit {
namespace {

constexpr std::array<ColourMember, 1> kDiffuse{&Colour::diffuse};
constexpr std::array<ColourMember, 3> kLobe{&Colour::scale, &Colour::reflectance, &Colour::diffuse};

bool is_diffuse(Columns columns) {
  return columns == Columns::diffuse || columns == Columns::quadratic_diffuse;
}

// A parameter's bounds; 0 and 1 where the table has it not.
struct Interval {
  double lower = 0, upper = 1;
};
Interval interval_of(std::span<const Parameter> parameters, std::string_view name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& p) { return p.name == name; });
  if (found == parameters.end()) return {};
  return {found->lower, found->upper};
}

}  // namespace

std::span<const ColourMember> members_of(Columns columns, std::size_t coefficients) {
  if (is_diffuse(columns)) return kDiffuse;
  return std::span(kLobe).first(coefficients);
}

std::string_view name_of(Columns columns, ColourMember member) {
  if (member == &Colour::diffuse) return "rd";
  if (member == &Colour::scale) return "scale";
  return columns == Columns::schlick ? "f0" : "rs";
}

Colour colour_of(Columns columns, std::span<const double> coefficients) {
  const auto& x = coefficients;
  if (is_diffuse(columns)) return {0, 0, x[0]};
  if (columns == Columns::scaled || columns == Columns::reflectance) return {x[0], 0, 0};
  Colour colour;
  colour.scale = x[0] + x[1];
  colour.reflectance = colour.scale > 0 ? x[0] / colour.scale : 0;
  const double rest = 1 - colour.reflectance;
  if (x.size() > 2 && x[2] > 0) colour.diffuse = x[2] / std::max(rest, 1e-300);
  return colour;
}

std::array<double, 3> coefficients_of(Columns columns, const Colour& colour) {
  if (is_diffuse(columns)) return {colour.diffuse, 0, 0};
  if (columns == Columns::scaled || columns == Columns::reflectance) return {colour.scale, 0, 0};
  const double rest = 1 - colour.reflectance;
  return {colour.scale * colour.reflectance, colour.scale * rest, colour.diffuse * rest};
}

std::array<double, 3> slopes_of(Columns columns, const Colour& colour, ColourMember member) {
  if (is_diffuse(columns) || columns == Columns::scaled || columns == Columns::reflectance)
    return {1, 0, 0};
  if (member == &Colour::scale) return {colour.reflectance, 1 - colour.reflectance, 0};
  if (member == &Colour::reflectance) return {colour.scale, -colour.scale, -colour.diffuse};
  return {0, 0, 1 - colour.reflectance};
}

ColourBounds colour_bounds(Columns columns, std::span<const Parameter> parameters) {
  const Interval scale = interval_of(parameters, "scale"), diffuse = interval_of(parameters, "rd");
  const Interval reflectance = interval_of(parameters, columns == Columns::schlick ? "f0" : "rs");
  ColourBounds bounds{{scale.lower, reflectance.lower, diffuse.lower},
                      {scale.upper, reflectance.upper, diffuse.upper}};
  if (columns != Columns::reflectance) return bounds;
  bounds.lower.scale *= reflectance.lower;
  bounds.upper.scale *= reflectance.upper;
  return bounds;
}

}  // namespace gonio::fit
