// What is fitted: the lobes of a material, the shape parameters that all channels share, and the
// columns of which each channel's reflectance is a sum.
//
// With the shape parameters held, f_c = sum_k v_k(x_c) column_k. Which parameters are shapes and
// which colours, and how f depends on a colour, stands in the models' tables (Quantity, Dependence
// in gonio/models/description.h). A lobe that an amplitude multiplies is one column, its colour the
// coefficient; one with an affine reflectance, such as Schlick's, is two, since scale (f0 + (1 -
// f0) w) = scale f0 + (scale (1 - f0)) w is linear in two numbers that are not negative; a base
// colour beside a lobe is one more. A specular column is divided by its lobe's value at normal
// incidence and h = n, so that a coefficient says how high the lobe is, whatever its width and
// Fresnel: a refractive index and an amplitude do not fight. A quadratic base colour is not linear:
// its second column takes the square of the first's coefficient.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/material/lobe_check.h"
#include "fit/bounds/colour.h"
#include "fit/search/shape.h"
#include "gonio/base/result.h"
#include "gonio/engine/material.h"

namespace gonio::fit {

struct FormLobe {
  const ModelDescription* model = nullptr;
  LobeSpec held;  // the model's name, its words, and the numbers that are not fitted
  LobeColours colours;
  // The colour at which columns are evaluated, where that is another than 1: the nearest to it that
  // the model's table allows.
  double evaluated_at = 1;
  std::size_t first_column = 0, column_count = 1;
  std::size_t first_coefficient = 0, coefficient_count = 1;
  std::string prefix;  // "diffuse.", "specular[0].", "" for a model alone
  bool alone = false;
};

struct Form {
  std::vector<FormLobe> lobes;
  std::vector<ShapeParameter> shapes;
  std::size_t columns = 0, coefficients = 0;  // of a channel
  // What measured values, f and coefficients are divided by while the fit works (unit.h).
  double unit = 1;
  // The rotation of the material's tangents in degrees, if the caller gives it; and the index in
  // `shapes` of the one that is fitted, if it is.
  std::optional<double> rotation;
  std::optional<std::size_t> rotation_shape;

  [[nodiscard]] std::size_t parameters(int channels) const {
    return shapes.size() + coefficients * static_cast<std::size_t>(channels);
  }
  // In the form's unit.
  [[nodiscard]] ColourBounds bounds_of(const FormLobe& lobe) const;
  // The place of a lobe's first coefficient of a channel among a fit's parameters.
  [[nodiscard]] std::size_t first_of(const FormLobe& lobe, std::size_t channel) const {
    return shapes.size() + channel * coefficients + lobe.first_coefficient;
  }
};

struct FormOptions {
  bool anisotropic = false;  // what belongs to the tangents u and v each by itself
  bool turned = false;       // the rotation is a shape, if any lobe has tangents
};

// From a specification whose words (and models) say what is fitted and whose numbers, where there
// are any, are the caller's guess. Errors are those of Material::create, or name what cannot be
// fitted: a measured table, colours that cannot be told apart.
Result<Form> make_form(const MaterialSpec& spec, const FormOptions& options);

// The same of what is checked already; its models need not be in the registry.
struct CheckedLobes {
  std::span<const NamedLobe> named;
  std::span<const CheckedLobe> lobes;
};
Result<Form> make_form(const CheckedLobes& checked, std::optional<double> rotation,
                       const FormOptions& options);

// As errors and reports name a parameter, "specular[0].parameters.alpha_x".
std::string field_of(const std::string& prefix, const Parameter& p);

// Whether any lobe has tangents.
bool has_tangents(const Form& form);

// Whether a lobe changes with a shape: its own, or the rotation of all that have tangents.
bool depends(const Form& form, std::size_t lobe, const ShapeParameter& shape);

// Of the material's tangents in degrees, by the shapes (search scale); none if it is neither given
// nor found.
std::optional<double> rotation_of(const Form& form, std::span<const double> shapes);

// The shape parameters of one lobe (search scale), within the bounds of its model's table.
void set_shapes(const Form& form, std::size_t lobe, std::span<const double> shapes, LobeSpec& to);

// One lobe with the given shapes (search scale) as the columns want it: a "channel" a column.
LobeSpec column_lobe(const Form& form, std::size_t lobe, std::span<const double> shapes);

// A lobe's colour in the form's unit from its coefficients in one channel. `peaks`: what each
// column is divided by (basis.h).
Colour colour_at(const FormLobe& lobe, std::span<const double> coefficients,
                 std::span<const double> peaks);

}  // namespace gonio::fit
