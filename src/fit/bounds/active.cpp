#include "fit/bounds/active.h"

#include <algorithm>
#include <utility>

#include "fit/linear/basis.h"

namespace gonio::fit {
namespace {

class Fields {
 public:
  // Where data are far above a colour's upper bound, that bound is itself close to the lower one:
  // then only the upper is named.
  void add(const std::string& field, bool lower, bool upper) {
    if (!lower && !upper) return;
    std::string name = field + (upper ? " (upper)" : " (lower)");
    if (std::find(names_.begin(), names_.end(), name) == names_.end())
      names_.push_back(std::move(name));
  }
  std::vector<std::string> names() && { return std::move(names_); }

 private:
  std::vector<std::string> names_;
};

bool is_at_upper(double x, double upper) { return x >= upper * (1 - kAtBound); }

// Without height a lobe has no reflectance that could be at a bound.
void add_colours(const Form& form, const FormLobe& lobe, std::span<const double> coefficients,
                 std::span<const double> peaks, double nothing, Fields& fields) {
  const Colour colour = colour_at(lobe, coefficients, peaks);
  const ColourBounds bounds = form.bounds_of(lobe);
  const bool no_lobe = colour.scale * peaks[lobe.first_column] <= nothing;
  for (const ColourMember member : lobe.colours.members()) {
    const double x = colour.*member, lower = bounds.lower.*member, upper = bounds.upper.*member;
    bool at_lower = x <= lower + nothing;
    if (member == &Colour::reflectance) {
      if (no_lobe) continue;
      at_lower = x <= lower + kAtBound;
    } else if (member == &Colour::scale) {
      at_lower = no_lobe || x <= lower;
    }
    fields.add(field_of(lobe.prefix, lobe.colours.parameter(member)), at_lower,
               is_at_upper(x, upper));
  }
}

}  // namespace

std::vector<std::string> active_bounds(const Form& form, std::span<const double> parameters,
                                       int channels, double nothing) {
  Fields fields;
  for (std::size_t i = 0; i < form.shapes.size(); ++i) {
    const ShapeParameter& shape = form.shapes[i];
    fields.add(shape.field, parameters[i] <= shape.scale.to_search(shape.lower) + kAtBound,
               parameters[i] >= shape.scale.to_search(shape.upper) - kAtBound);
  }
  const BasisAt at(form, parameters.first(form.shapes.size()), false);
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
    for (const FormLobe& lobe : form.lobes) {
      add_colours(form, lobe, parameters.subspan(form.first_of(lobe, c), lobe.coefficient_count),
                  at.peaks(), nothing, fields);
    }
  }
  return std::move(fields).names();
}

std::vector<std::size_t> inside_bounds(const Form& form, std::span<const double> coordinates,
                                       const Bounds& bounds, double nothing) {
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const bool shape = i < form.shapes.size();
    const double x = coordinates[i], upper = bounds.upper[i];
    const bool at_upper = shape ? x >= upper - kAtBound : is_at_upper(x, upper);
    if (!at_upper && x > bounds.lower[i] + (shape ? kAtBound : nothing)) inside.push_back(i);
  }
  return inside;
}

}  // namespace gonio::fit
