// The numbers of a fitted material and their bounds, for tests that move them one by one.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fit/form.h"
#include "fit/report/metrics.h"
#include "gonio/engine/material.h"
#include "gonio/engine/registry.h"

namespace gonio::testing {

// A number of one lobe, or two that are held equal. `lobe` 0 is the base, or a material alone.
struct Number {
  std::size_t lobe = 0;
  std::vector<std::string> names;
  double lower = 0, upper = 1, start = 0;
  bool logarithmic = false;

  // Even steps in the scale in which the number is searched; colours of a wide range go by factors.
  [[nodiscard]] double stepped(double value, double step) const {
    const double offset = lower <= 0 && upper > 1 ? 1e-3 * start + 1e-9 : 0;
    const bool factor = logarithmic || upper > 10;
    const double moved =
        factor ? (value + offset) * std::exp(step) - offset : value + 0.3 * step * (upper - lower);
    return std::clamp(moved, lower, upper);
  }
};

inline LobeSpec& lobe_of(MaterialSpec& spec, std::size_t lobe) {
  if (spec.model) return *spec.model;
  return lobe == 0 ? *spec.diffuse : spec.specular[lobe - 1];
}

inline double value_of(MaterialSpec spec, const Number& number) {
  const auto& parameters = lobe_of(spec, number.lobe).parameters;
  return std::get<std::vector<double>>(parameters.at(number.names.front())).front();
}

inline MaterialSpec with(MaterialSpec spec, const Number& number, double value) {
  for (const std::string& name : number.names)
    lobe_of(spec, number.lobe).parameters[name] = std::vector{value};
  return spec;
}

// All numbers that a fit of `form` sets: its shapes, and the colours of its lobes.
inline std::vector<Number> numbers_of(const fit::Form& form) {
  std::vector<Number> numbers;
  for (const fit::ShapeParameter& shape : form.shapes)
    numbers.push_back(
        {shape.lobe, shape.names, shape.lower, shape.upper, shape.start, shape.scale.logarithmic});
  for (std::size_t i = 0; i < form.lobes.size(); ++i) {
    const fit::LobeColours& colours = form.lobes[i].colours;
    for (const Parameter& p : form.lobes[i].model->parameters) {
      if (&p == colours.scale || &p == colours.reflectance || &p == colours.diffuse)
        numbers.push_back({i, {std::string(p.name)}, p.lower, p.upper, p.start, false});
    }
  }
  return numbers;
}

inline double error_of(const MaterialSpec& spec, const fit::Data& data) {
  return fit::compare(*Material::create(spec), data, 0).errors.all.l1;
}

// The least L1 that steps of one number at a time come to, from `spec`.
inline double searched(MaterialSpec spec, const std::vector<Number>& numbers,
                       const fit::Data& data) {
  double best = error_of(spec, data);
  for (double step = 0.5; step > 1e-3;) {
    const double before = best;
    for (const Number& number : numbers) {
      for (const double signed_step : {step, -step}) {
        MaterialSpec next = with(spec, number, number.stepped(value_of(spec, number), signed_step));
        const double error = error_of(next, data);
        if (error >= best) continue;
        best = error;
        spec = std::move(next);
      }
    }
    if (best >= 0.999 * before) step /= 2;
  }
  return best;
}

}  // namespace gonio::testing
