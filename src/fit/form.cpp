#include "fit/form.h"

#include <algorithm>
#include <numeric>

#include "engine/material/material_impl.h"
#include "fit/bounds/lobe_colours.h"

namespace gonio::fit {
namespace {

double mean(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

const std::vector<double>& values_of(const CheckedLobe& lobe, const Parameter& p) {
  return lobe.values.all().find(p.name)->second;
}

// If `name` is the parameter along the second tangent, that of the first: they are held equal where
// the material is isotropic.
ShapeParameter* tied_to(std::string_view name, const ModelDescription& model,
                        std::vector<ShapeParameter>& shapes, std::size_t lobe) {
  const auto& [first, second] = model.along_tangents;
  if (!model.has_tangents() || name != second) return nullptr;
  const auto found = std::find_if(shapes.begin(), shapes.end(), [&, &u = first](const auto& shape) {
    return shape.lobe == lobe && shape.names.front() == u;
  });
  return found == shapes.end() ? nullptr : &*found;
}

bool is_shape(const CheckedLobe& lobe, const Parameter& p) {
  if (p.type == ParameterType::word || !p.fitted || !is_used(lobe, p.used_with)) return false;
  const Quantity quantity = quantity_of(p, lobe.model->role);
  return quantity == Quantity::shape || quantity == Quantity::refractive_index ||
         quantity == Quantity::extinction;
}

void add_shapes(const NamedLobe& named, const CheckedLobe& lobe, const FormOptions& options,
                Form& form) {
  const std::size_t index = form.lobes.size() - 1;
  const bool dielectric = find_used(lobe, Quantity::extinction) == nullptr;
  for (const Parameter& p : lobe.model->parameters) {
    if (!is_shape(lobe, p)) continue;
    ShapeParameter* partner =
        options.anisotropic ? nullptr : tied_to(p.name, *lobe.model, form.shapes, index);
    if (partner != nullptr) {
      partner->names.emplace_back(p.name);
      continue;
    }
    ShapeParameter shape = shape_of(p, quantity_of(p, lobe.model->role), dielectric);
    shape.lobe = index;
    shape.field = field_of(named.prefix, p);
    if (named.spec->parameters.contains(p.name))
      shape.guess = std::clamp(mean(values_of(lobe, p)), shape.lower, shape.upper);
    form.shapes.push_back(std::move(shape));
  }
}

// Its words, and the numbers that the fit leaves alone. In a sum a lobe has no diffuse term.
LobeSpec held_of(const NamedLobe& named, const CheckedLobe& lobe, const LobeColours& colours) {
  LobeSpec held{named.spec->model, {}};
  for (const Parameter& p : lobe.model->parameters) {
    const std::string name(p.name);
    if (p.type == ParameterType::word) {
      held.parameters[name] = std::string(word_of(lobe, p.name));
    } else if (!p.fitted && is_used(lobe, p.used_with)) {
      held.parameters[name] = std::vector{mean(values_of(lobe, p))};
    } else if (is_fitted_colour(lobe, p) && &p != colours.scale && &p != colours.reflectance &&
               &p != colours.diffuse) {
      held.parameters[name] = std::vector{p.lower};
    }
  }
  return held;
}

double nearest_to_one(const Parameter* p) {
  return p == nullptr ? 1 : std::clamp(1.0, p->lower, p->upper);
}

double evaluated_at(const LobeColours& colours) {
  if (is_diffuse(colours.columns)) return nearest_to_one(colours.diffuse);
  const double scale = nearest_to_one(colours.scale);
  return colours.columns == Columns::scaled ? scale * nearest_to_one(colours.reflectance) : scale;
}

Outcome add_lobe(const NamedLobe& named, const CheckedLobe& checked, const FormOptions& options,
                 Form& form) {
  const Result<LobeColours> colours = lobe_colours(checked, named);
  if (!colours) return colours.error();
  FormLobe lobe;
  lobe.model = checked.model;
  lobe.held = held_of(named, checked, *colours);
  lobe.colours = *colours;
  lobe.evaluated_at = evaluated_at(*colours);
  lobe.prefix = named.prefix;
  lobe.alone = named.prefix.empty();
  lobe.coefficient_count = colours->members().size();
  lobe.column_count = lobe.coefficient_count;
  if (colours->columns == Columns::quadratic_diffuse) ++lobe.column_count;
  lobe.first_column = form.columns;
  lobe.first_coefficient = form.coefficients;
  form.columns += lobe.column_count;
  form.coefficients += lobe.coefficient_count;
  form.lobes.push_back(std::move(lobe));
  add_shapes(named, checked, options, form);
  return Ok{};
}

void add_rotation(Form& form) {
  const auto turns = std::find_if(form.lobes.begin(), form.lobes.end(),
                                  [](const auto& lobe) { return lobe.model->has_tangents(); });
  if (turns == form.lobes.end()) return;
  form.rotation_shape = form.shapes.size();
  form.shapes.push_back(rotation_shape(static_cast<std::size_t>(turns - form.lobes.begin())));
}

}  // namespace

ColourBounds Form::bounds_of(const FormLobe& lobe) const {
  ColourBounds bounds = lobe.colours.bounds();
  for (Colour* colour : {&bounds.lower, &bounds.upper}) {
    colour->scale /= unit;
    colour->diffuse /= unit;
  }
  return bounds;
}

std::string field_of(const std::string& prefix, const Parameter& p) {
  return prefix + "parameters." + std::string(p.name);
}

bool has_tangents(const Form& form) {
  return std::any_of(form.lobes.begin(), form.lobes.end(),
                     [](const FormLobe& lobe) { return lobe.model->has_tangents(); });
}

Result<Form> make_form(const CheckedLobes& checked, std::optional<double> rotation,
                       const FormOptions& options) {
  Form form;
  for (std::size_t i = 0; i < checked.lobes.size(); ++i) {
    if (auto ok = add_lobe(checked.named[i], checked.lobes[i], options, form); !ok)
      return ok.error();
  }
  form.rotation = rotation;
  if (options.turned) add_rotation(form);
  return form;
}

Result<Form> make_form(const MaterialSpec& spec, const FormOptions& options) {
  const Result<CheckedMaterial> checked = check_material(spec, {});
  if (!checked) return checked.error();
  return make_form({checked->named, checked->lobes}, spec.rotation, options);
}

}  // namespace gonio::fit
