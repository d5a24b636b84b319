// What is fitted: the lobes of a material, the shape parameters that all channels share, and the
// columns of which each channel's reflectance is a sum.
//
// With the shape parameters held, f_c = sum_k v_k(x_c) column_k: a lobe without Fresnel, or with
// that of a dielectric or conductor, is one column (its colour scale the coefficient); one with
// Schlick's is two, since scale (f0 + (1 - f0) w) = scale f0 + (scale (1 - f0)) w is linear in two
// numbers that are not negative; Ashikhmin and Shirley's own diffuse term is one more. A specular
// column is divided by its lobe's value at normal incidence and h = n, so that a coefficient says
// how high the lobe is, whatever its width and Fresnel: eta and scale do not fight. The one model
// that is not linear in its colour, oren_nayar's full form, is quadratic: its second column takes
// the square of the first's coefficient.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/bounds/colour.h"
#include "fit/search/shape.h"
#include "gonio/base/result.h"
#include "gonio/engine/material.h"

namespace gonio::fit {

struct FormLobe {
  LobeSpec words;  // the model and its words, no numbers
  Columns columns = Columns::scaled;
  ColourBounds bounds;  // of the model's table
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
};

struct FormOptions {
  bool anisotropic = false;  // nu and nv, alpha_x and alpha_y each by themselves
  bool turned = false;       // the rotation is a shape, if any lobe has tangents
};

// From a specification whose words (and models) say what is fitted and whose numbers, where there
// are any, are the caller's guess. Errors are those of Material::create, or name what cannot be
// fitted (a measured table).
Result<Form> make_form(const MaterialSpec& spec, const FormOptions& options);

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
