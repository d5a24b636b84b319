// A form's lobes with their numbers set: what columns are evaluated from.
#include <algorithm>
#include <array>

#include "fit/form.h"
#include "gonio/models/description.h"

namespace gonio::fit {
namespace {

using Numbers = std::vector<double>;

bool is_rotation(const Form& form, const ShapeParameter& shape) {
  return form.rotation_shape && &shape == &form.shapes[*form.rotation_shape];
}

void set(const Parameter* p, Numbers numbers, LobeSpec& to) {
  if (p != nullptr) to.parameters[std::string(p->name)] = std::move(numbers);
}

void set_nearest_to_one(const Parameter* p, LobeSpec& to) {
  if (p != nullptr) set(p, {std::clamp(1.0, p->lower, p->upper)}, to);
}

// The colours of each column, a "channel" a column; what multiplies a whole lobe is 1, or as near
// to it as the table allows (FormLobe::evaluated_at).
void set_colours(const LobeColours& colours, LobeSpec& to) {
  switch (colours.columns) {
    case Columns::diffuse:
      return set_nearest_to_one(colours.diffuse, to);
    // Two points of the parabola; its coefficients are worked out from them.
    case Columns::quadratic_diffuse:
      return set(colours.diffuse, {0.5, 1}, to);
    case Columns::scaled:
      set_nearest_to_one(colours.scale, to);
      return set_nearest_to_one(colours.reflectance, to);
    case Columns::affine:
      set_nearest_to_one(colours.scale, to);
      return set(colours.reflectance, {1, 0}, to);
    case Columns::affine_over_base: {
      const double one = std::clamp(1.0, colours.scale->lower, colours.scale->upper);
      set(colours.scale, {one, one, 0}, to);
      set(colours.reflectance, {1, 0, 0}, to);
      return set(colours.diffuse, {0, 0, 1}, to);
    }
  }
}

}  // namespace

bool depends(const Form& form, std::size_t lobe, const ShapeParameter& shape) {
  if (!is_rotation(form, shape)) return shape.lobe == lobe;
  return form.lobes[lobe].model->has_tangents();
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
  LobeSpec spec = lobe.held;
  set_shapes(form, index, shapes, spec);
  set_colours(lobe.colours, spec);
  return spec;
}

Colour colour_at(const FormLobe& lobe, std::span<const double> coefficients,
                 std::span<const double> peaks) {
  std::array<double, 3> relative{};
  for (std::size_t k = 0; k < lobe.coefficient_count; ++k)
    relative[k] = coefficients[k] / peaks[lobe.first_column + k];
  return colour_of(lobe.colours.columns, std::span(relative).first(lobe.coefficient_count));
}

}  // namespace gonio::fit
