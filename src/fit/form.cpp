#include "fit/form.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "engine/material/material_impl.h"
#include "gonio/engine/registry.h"

namespace gonio::fit {
namespace {

// What a channel's coefficients stand for: all other numbers are shapes, shared by the channels.
constexpr std::array<std::string_view, 4> kColours{"rd", "rs", "f0", "scale"};
bool is_colour(const Parameter& p) {
  return std::find(kColours.begin(), kColours.end(), p.name) != kColours.end();
}

// The words of a checked lobe: its kind counts their combinations, the last word the fastest.
std::map<std::string, std::string, std::less<>> words_of(const CheckedLobe& lobe) {
  std::map<std::string, std::string, std::less<>> words;
  std::size_t kind = lobe.kind;
  const auto& all = lobe.model->parameters;
  for (std::size_t i = all.size(); i-- > 0;) {
    if (all[i].type != ParameterType::word) continue;
    words[std::string(all[i].name)] = all[i].words[kind % all[i].words.size()];
    kind /= all[i].words.size();
  }
  return words;
}

bool is_used(const Parameter& p, const std::map<std::string, std::string, std::less<>>& words) {
  if (p.used_with.parameter.empty()) return true;
  const auto word = words.find(p.used_with.parameter);
  const auto& with = p.used_with.words;
  return word != words.end() && std::find(with.begin(), with.end(), word->second) != with.end();
}

bool has(const ModelDescription& model, std::string_view name) {
  return std::any_of(model.parameters.begin(), model.parameters.end(),
                     [&](const Parameter& p) { return p.name == name; });
}

Columns columns_of(const CheckedLobe& lobe,
                   const std::map<std::string, std::string, std::less<>>& words) {
  const auto is = [&](std::string_view name, std::string_view word) {
    const auto found = words.find(name);
    return found != words.end() && found->second == word;
  };
  if (lobe.model->role == Role::diffuse)
    return is("form", "full") ? Columns::quadratic_diffuse : Columns::diffuse;
  if (has(*lobe.model, "rs")) {
    return has(*lobe.model, "rd") ? Columns::ashikhmin_shirley : Columns::reflectance;
  }
  return is("fresnel", "schlick") ? Columns::schlick : Columns::scaled;
}

double mean(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
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

void add_shapes(const NamedLobe& named, const CheckedLobe& lobe,
                const std::map<std::string, std::string, std::less<>>& words,
                const FormOptions& options, Form& form) {
  const std::size_t index = form.lobes.size() - 1;
  const auto fresnel = words.find("fresnel");
  const bool dielectric = fresnel != words.end() && fresnel->second == "dielectric";
  for (const Parameter& p : lobe.model->parameters) {
    if (p.type == ParameterType::word || is_colour(p) || !is_used(p, words)) continue;
    ShapeParameter* partner =
        options.anisotropic ? nullptr : tied_to(p.name, *lobe.model, form.shapes, index);
    if (partner != nullptr) {
      partner->names.emplace_back(p.name);
      continue;
    }
    ShapeParameter shape = shape_of(p, dielectric);
    shape.lobe = index;
    shape.field = named.prefix + "parameters." + std::string(p.name);
    if (named.spec->parameters.contains(p.name)) {
      const double given = mean(lobe.values.all().find(p.name)->second);
      shape.guess = std::clamp(given, shape.lower, shape.upper);
    }
    form.shapes.push_back(std::move(shape));
  }
}

struct Counts {
  std::size_t columns, coefficients;
};
Counts counts_of(Columns columns, bool alone) {
  switch (columns) {
    case Columns::diffuse:
    case Columns::scaled:
    case Columns::reflectance:
      return {1, 1};
    case Columns::quadratic_diffuse:
      return {2, 1};
    case Columns::schlick:
      return {2, 2};
    // Its own diffuse term only where it stands alone.
    case Columns::ashikhmin_shirley:
      return alone ? Counts{3, 3} : Counts{2, 2};
  }
  return {};
}

void add_lobe(const NamedLobe& named, const CheckedLobe& checked, const FormOptions& options,
              Form& form) {
  const auto words = words_of(checked);
  FormLobe lobe;
  lobe.words.model = named.spec->model;
  for (const auto& [name, word] : words) lobe.words.parameters[name] = word;
  lobe.columns = columns_of(checked, words);
  lobe.bounds = colour_bounds(lobe.columns, checked.model->parameters);
  lobe.prefix = named.prefix;
  lobe.alone = named.prefix.empty();
  const Counts counts = counts_of(lobe.columns, lobe.alone);
  lobe.first_column = form.columns;
  lobe.column_count = counts.columns;
  lobe.first_coefficient = form.coefficients;
  lobe.coefficient_count = counts.coefficients;
  form.columns += counts.columns;
  form.coefficients += counts.coefficients;
  form.lobes.push_back(std::move(lobe));
  add_shapes(named, checked, words, options, form);
}

void add_rotation(const CheckedMaterial& material, Form& form) {
  const auto turns = std::find_if(material.lobes.begin(), material.lobes.end(),
                                  [](const auto& lobe) { return lobe.model->has_tangents(); });
  if (turns == material.lobes.end()) return;
  form.rotation_shape = form.shapes.size();
  form.shapes.push_back(rotation_shape(static_cast<std::size_t>(turns - material.lobes.begin())));
}

bool is_rotation(const Form& form, const ShapeParameter& shape) {
  return form.rotation_shape && &shape == &form.shapes[*form.rotation_shape];
}

}  // namespace

ColourBounds Form::bounds_of(const FormLobe& lobe) const {
  ColourBounds bounds = lobe.bounds;
  for (Colour* colour : {&bounds.lower, &bounds.upper}) {
    colour->scale /= unit;
    colour->diffuse /= unit;
  }
  return bounds;
}

Colour colour_at(const FormLobe& lobe, std::span<const double> coefficients,
                 std::span<const double> peaks) {
  std::array<double, 3> relative{};
  for (std::size_t k = 0; k < lobe.coefficient_count; ++k)
    relative[k] = coefficients[k] / peaks[lobe.first_column + k];
  return colour_of(lobe.columns, std::span(relative).first(lobe.coefficient_count));
}

bool depends(const Form& form, std::size_t lobe, const ShapeParameter& shape) {
  if (!is_rotation(form, shape)) return shape.lobe == lobe;
  return (*find_model(form.lobes[lobe].words.model))->has_tangents();
}

std::optional<double> rotation_of(const Form& form, std::span<const double> shapes) {
  if (!form.rotation_shape) return form.rotation;
  const ShapeParameter& shape = form.shapes[*form.rotation_shape];
  return std::clamp(shapes[*form.rotation_shape], shape.lower, shape.upper);
}

void set_shapes(const Form& form, std::size_t lobe, std::span<const double> shapes, LobeSpec& to) {
  for (std::size_t i = 0; i < form.shapes.size(); ++i) {
    const ShapeParameter& shape = form.shapes[i];
    if (shape.lobe != lobe || is_rotation(form, shape)) continue;
    const double p = std::clamp(shape.scale.to_parameter(shapes[i]), shape.lower, shape.upper);
    for (const std::string& name : shape.names) to.parameters[name] = std::vector{p};
  }
}

LobeSpec column_lobe(const Form& form, std::size_t index, std::span<const double> shapes) {
  const FormLobe& lobe = form.lobes[index];
  LobeSpec spec = lobe.words;
  set_shapes(form, index, shapes, spec);
  using Numbers = std::vector<double>;
  switch (lobe.columns) {
    case Columns::diffuse:
      spec.parameters["rd"] = Numbers{1};
      break;
    // Two points of the parabola; its coefficients are worked out from them.
    case Columns::quadratic_diffuse:
      spec.parameters["rd"] = Numbers{0.5, 1};
      break;
    case Columns::scaled:
      spec.parameters["scale"] = Numbers{1};
      break;
    case Columns::reflectance:
      spec.parameters["rs"] = Numbers{1};
      break;
    case Columns::schlick:
      spec.parameters["f0"] = Numbers{1, 0};
      break;
    case Columns::ashikhmin_shirley:
      spec.parameters["rs"] = lobe.column_count == 3 ? Numbers{1, 0, 0} : Numbers{1, 0};
      if (lobe.column_count == 3) {
        spec.parameters["rd"] = Numbers{0, 0, 1};
        spec.parameters["scale"] = Numbers{1, 1, 0};
      }
      break;
  }
  return spec;
}

Result<Form> make_form(const MaterialSpec& spec, const FormOptions& options) {
  const Result<CheckedMaterial> checked = check_material(spec, {});
  if (!checked) return checked.error();
  Form form;
  for (std::size_t i = 0; i < checked->lobes.size(); ++i)
    add_lobe(checked->named[i], checked->lobes[i], options, form);
  form.rotation = spec.rotation;
  if (options.turned) add_rotation(*checked, form);
  return form;
}

}  // namespace gonio::fit
