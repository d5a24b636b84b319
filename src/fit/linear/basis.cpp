#include "fit/linear/basis.h"

#include <algorithm>
#include <cassert>

#include "gonio/engine/isa.h"

namespace gonio::fit {
namespace {

// Where a lobe's height is measured: wi = wo = n.
Data straight_up() {
  Data data;
  data.channels = 1;
  for (auto* w : {&data.wi, &data.wo}) *w = {std::vector{0.F}, std::vector{0.F}, std::vector{1.F}};
  data.weights = {1};
  return data;
}

// Those of the lobe itself: its own diffuse term is no part of it.
std::size_t columns_of_height(const FormLobe& lobe) {
  return std::min<std::size_t>(lobe.column_count, 2);
}

// From a parabola's values at 1/2 and 1 (and 0 at 0) to its two coefficients; that of the square
// of a number that is divided by `unit`.
void to_parabola(double* at_half, double* at_one, std::size_t count, double unit) {
  for (std::size_t i = 0; i < count; ++i) {
    const double half = at_half[i], one = at_one[i];
    at_half[i] = 4 * half - one;
    at_one[i] = 2 * (one - 2 * half) * unit;
  }
}

void to_unit_colour(double* column, std::size_t count, double evaluated_at) {
  for (std::size_t i = 0; i < count; ++i) column[i] /= evaluated_at;
}

}  // namespace

BasisAt::BasisAt(const Form& form, std::span<const double> shapes, bool derivatives)
    : form_(form), shape_count_(form.shapes.size()) {
  for (std::size_t lobe = 0; lobe < form.lobes.size(); ++lobe) {
    const MaterialSpec spec{column_lobe(form, lobe, shapes), {}, {}, rotation_of(form, shapes)};
    Result<Material> material = Material::create(spec);
    assert(material.ok());  // the form was made from a valid one, and shapes are clamped
    lobes_.push_back({std::move(material).value(), {}});
    for (std::size_t p = 0; derivatives && p < shape_count_; ++p) {
      const ShapeParameter& shape = form.shapes[p];
      if (!depends(form, lobe, shape)) continue;
      ByShape by{p, shape.scale.slope(shapes[p]), {}};
      for (const std::string& name : shape.names) {
        Result<MaterialDerivative> d =
            MaterialDerivative::create(spec, name == kRotation.name ? name : "parameters." + name);
        assert(d.ok());
        by.by.push_back(std::move(d).value());
      }
      lobes_.back().shapes.push_back(std::move(by));
    }
  }
  peaks_.assign(form.columns, 1);
  peak_slopes_.assign(shape_count_ * form.columns, 0);
  measure_peaks();
}

void BasisAt::measure_peaks() {
  Basis peak;
  evaluate(straight_up(), 0, 1, peak);
  for (const FormLobe& lobe : form_.lobes) {
    if (is_diffuse(lobe.colours.columns)) continue;
    const double height = std::max(peak.values[lobe.first_column * peak.stride], 1e-300);
    for (std::size_t k = lobe.first_column; k < lobe.first_column + columns_of_height(lobe); ++k) {
      peaks_[k] = height;
      for (std::size_t p = 0; p < shape_count_ && !peak.derivatives.empty(); ++p) {
        const std::size_t first = p * form_.columns + lobe.first_column;
        peak_slopes_[p * form_.columns + k] = peak.derivatives[first * peak.stride] / height;
      }
    }
  }
}

void BasisAt::evaluate_lobe(std::size_t index, const Batch<float, double>& batch, Basis& to) const {
  const FormLobe& form = form_.lobes[index];
  const Isa isa = best_isa();
  Batch<float, double> here = batch;
  here.values = {&to.values[form.first_column * to.stride], 1,
                 static_cast<std::ptrdiff_t>(to.stride)};
  gonio::evaluate(lobes_[index].material, here, isa);
  std::vector<double> second;
  for (const ByShape& shape : lobes_[index].shapes) {
    double* target = &to.derivatives[(shape.shape * form_.columns + form.first_column) * to.stride];
    const std::size_t numbers = form.column_count * to.stride;
    here.values.data = target;
    shape.by.front().evaluate(here, isa);
    for (std::size_t i = 1; i < shape.by.size(); ++i) {
      second.resize(numbers);
      here.values.data = second.data();
      shape.by[i].evaluate(here, isa);
      for (std::size_t j = 0; j < numbers; ++j) target[j] += second[j];
    }
    for (std::size_t j = 0; j < numbers; ++j) target[j] *= shape.slope;
  }
}

// Divides a lobe's columns by their height, whose own derivatives come in.
void BasisAt::normalise(std::size_t index, std::size_t count, Basis& to) const {
  const FormLobe& lobe = form_.lobes[index];
  for (std::size_t k = lobe.first_column; k < lobe.first_column + lobe.column_count; ++k) {
    const double factor = 1 / peaks_[k];
    double* column = &to.values[k * to.stride];
    for (std::size_t i = 0; i < count; ++i) column[i] *= factor;
    for (const ByShape& shape : lobes_[index].shapes) {
      const std::size_t at = shape.shape * form_.columns + k;
      double* by = &to.derivatives[at * to.stride];
      const double slope = peak_slopes_[at];
      for (std::size_t i = 0; i < count; ++i) by[i] = by[i] * factor - column[i] * slope;
    }
  }
}

void BasisAt::evaluate(const Data& data, std::size_t first, std::size_t count, Basis& to) const {
  const bool derivatives = std::any_of(lobes_.begin(), lobes_.end(),
                                       [](const Lobe& lobe) { return !lobe.shapes.empty(); });
  // A multiple of every packet's width, so that the engine writes to where it should at once.
  to.stride = (count + 15) / 16 * 16;
  to.values.resize(form_.columns * to.stride);
  to.derivatives.resize(derivatives ? shape_count_ * form_.columns * to.stride : 0);
  const Batch<float, double> batch{data.incident(first), data.outgoing(first), count, {}, nullptr};
  for (std::size_t lobe = 0; lobe < form_.lobes.size(); ++lobe) {
    evaluate_lobe(lobe, batch, to);
    const FormLobe& form = form_.lobes[lobe];
    const auto each = [&](const auto& change) {
      change(&to.values[form.first_column * to.stride]);
      for (const ByShape& shape : lobes_[lobe].shapes)
        change(&to.derivatives[(shape.shape * form_.columns + form.first_column) * to.stride]);
    };
    if (form.colours.columns == Columns::quadratic_diffuse)
      each([&](double* at) { to_parabola(at, at + to.stride, count, form_.unit); });
    if (form.evaluated_at != 1) {
      const std::size_t numbers = columns_of_height(form) * to.stride;
      each([&](double* at) { to_unit_colour(at, numbers, form.evaluated_at); });
    }
    normalise(lobe, count, to);
  }
}

}  // namespace gonio::fit
