#include "fit/bounds/lobe_colours.h"

#include <string>
#include <utility>

namespace gonio::fit {
namespace {

Dependence dependence_of(const CheckedLobe& lobe, const Parameter& p) {
  return is_used(lobe, p.dependence_with) ? p.dependence : Dependence::linear;
}

Error refused(const NamedLobe& named, const Parameter& p, const std::string& value,
              const std::string& allowed) {
  return bad_value(named.prefix + "parameters." + std::string(p.name), value, allowed);
}

// Where a fit needs f at a colour of 0 and of 1 the table must allow both.
Outcome check_bounds(const NamedLobe& named, const Parameter& p, Dependence dependence) {
  const bool enough =
      dependence == Dependence::linear ? p.lower >= 0 && p.upper > 0 : p.lower == 0 && p.upper >= 1;
  if (enough) return Ok{};
  return refused(named, p, "bounds " + std::to_string(p.lower) + " to " + std::to_string(p.upper),
                 dependence == Dependence::linear
                     ? "for a fit, bounds of at least 0"
                     : "for a fit of a colour that f is not proportional to, bounds from 0 to 1 or "
                       "more");
}

// Each by its quantity. Errors: two of one quantity.
Result<LobeColours> found_colours(const CheckedLobe& lobe, const NamedLobe& named) {
  LobeColours found;
  for (const Parameter& p : lobe.model->parameters) {
    if (!is_fitted_colour(lobe, p)) continue;
    const Quantity quantity = quantity_of(p, lobe.model->role);
    const Parameter*& place = quantity == Quantity::amplitude     ? found.scale
                              : quantity == Quantity::reflectance ? found.reflectance
                                                                  : found.diffuse;
    if (place != nullptr) {
      return refused(named, p, "a second colour of its kind beside " + std::string(place->name),
                     "for a fit, one amplitude, one reflectance and one base colour");
    }
    place = &p;
    if (auto ok = check_bounds(named, p, dependence_of(lobe, p)); !ok) return ok.error();
  }
  return found;
}

Result<Columns> diffuse_columns(const CheckedLobe& lobe, const NamedLobe& named,
                                const Parameter& base) {
  const Dependence dependence = dependence_of(lobe, base);
  if (dependence == Dependence::affine || !base.dimmed_by.empty())
    return refused(named, base, "a base colour alone", "for a fit, a linear or quadratic one");
  return dependence == Dependence::linear ? Columns::diffuse : Columns::quadratic_diffuse;
}

// Of a lobe that has an amplitude, a reflectance, or both.
Result<Columns> lobe_columns(const CheckedLobe& lobe, const NamedLobe& named,
                             const LobeColours& colours) {
  const Parameter& first = colours.scale != nullptr ? *colours.scale : *colours.reflectance;
  const bool affine = colours.reflectance != nullptr &&
                      dependence_of(lobe, *colours.reflectance) == Dependence::affine;
  for (const Parameter* p : {colours.scale, colours.reflectance}) {
    if (p == nullptr || dependence_of(lobe, *p) == Dependence::linear) continue;
    if (affine && p == colours.reflectance && colours.scale != nullptr) continue;
    return refused(named, *p, "a colour that the lobe is not proportional to",
                   "for a fit, a linear one, or an affine reflectance beside an amplitude");
  }
  if (colours.diffuse == nullptr) return affine ? Columns::affine : Columns::scaled;
  const Parameter& base = *colours.diffuse;
  const bool dimmed = affine && base.dimmed_by == colours.reflectance->name &&
                      dependence_of(lobe, base) == Dependence::linear;
  // The columns are evaluated one without the other.
  const bool apart = first.lower == 0 && base.lower == 0 && base.upper >= 1;
  if (dimmed && apart) return Columns::affine_over_base;
  return refused(named, base, "a base colour beside " + std::string(first.name),
                 "for a fit, a linear one that an affine reflectance dims, with bounds from 0");
}

}  // namespace

bool is_fitted_colour(const CheckedLobe& lobe, const Parameter& p) {
  if (p.type != ParameterType::colour || !p.fitted || !is_used(lobe, p.used_with)) return false;
  const Quantity quantity = quantity_of(p, lobe.model->role);
  return quantity == Quantity::amplitude || quantity == Quantity::reflectance ||
         quantity == Quantity::base;
}

Result<LobeColours> lobe_colours(const CheckedLobe& lobe, const NamedLobe& named) {
  Result<LobeColours> found = found_colours(lobe, named);
  if (!found) return found;
  LobeColours colours = *found;
  const bool has_lobe = colours.scale != nullptr || colours.reflectance != nullptr;
  if (!has_lobe && colours.diffuse == nullptr) {
    return bad_value(named.prefix + "model", '"' + std::string(lobe.model->name) + '"',
                     "for a fit, a model with a colour that f grows with");
  }
  if (has_lobe && !named.prefix.empty()) colours.diffuse = nullptr;
  const Result<Columns> columns = has_lobe ? lobe_columns(lobe, named, colours)
                                           : diffuse_columns(lobe, named, *colours.diffuse);
  if (!columns) return columns.error();
  colours.columns = *columns;
  // A reflectance by itself is the height of its lobe.
  if (colours.scale == nullptr) std::swap(colours.scale, colours.reflectance);
  return colours;
}

}  // namespace gonio::fit
