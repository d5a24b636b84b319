#include "fit/report/material_numbers.h"

#include <algorithm>
#include <cmath>

#include "fit/linear/basis.h"

namespace gonio::fit {
namespace {

bool is_colour_of(const LobeColours& colours, const Parameter& p) {
  return &p == colours.scale || &p == colours.reflectance || &p == colours.diffuse;
}

void append_numbers(const FormLobe& lobe, const LobeSpec& spec, int channels,
                    std::vector<MaterialNumber>& to) {
  for (const Parameter& p : lobe.model->parameters) {
    const auto found = spec.parameters.find(p.name);
    if (found == spec.parameters.end() || lobe.held.parameters.contains(p.name)) continue;
    const auto& numbers = std::get<std::vector<double>>(found->second);
    const bool shared = !is_colour_of(lobe.colours, p);
    for (int c = 0; c < (shared ? 1 : channels); ++c) {
      const double value = numbers[numbers.size() == 1 ? 0 : static_cast<std::size_t>(c)];
      to.push_back({field_of(lobe.prefix, p), shared ? -1 : c, value, &p});
    }
  }
}

}  // namespace

std::vector<MaterialNumber> numbers_of(const Form& form, std::span<const double> parameters,
                                       int channels, bool exact) {
  const MaterialSpec spec = to_material(form, parameters, channels, exact);
  std::vector<MaterialNumber> numbers;
  std::size_t specular = 0;
  for (const FormLobe& lobe : form.lobes) {
    const LobeSpec& made = lobe.alone                  ? *spec.model
                           : lobe.prefix == "diffuse." ? *spec.diffuse
                                                       : spec.specular[specular++];
    append_numbers(lobe, made, channels, numbers);
  }
  if (form.rotation_shape)
    numbers.push_back({std::string(kRotation.name), -1, *spec.rotation, &kRotation});
  return numbers;
}

Eigen::MatrixXd slopes_of(const Form& form, std::span<const double> parameters, int channels,
                          const std::vector<MaterialNumber>& numbers) {
  Eigen::MatrixXd J(static_cast<Eigen::Index>(numbers.size()),
                    static_cast<Eigen::Index>(parameters.size()));
  std::vector<double> x(parameters.begin(), parameters.end());
  for (std::size_t j = 0; j < x.size(); ++j) {
    const double step = 1e-5 * std::max(std::abs(x[j]), 1e-3);
    x[j] = parameters[j] + step;
    const auto above = numbers_of(form, x, channels, true);
    x[j] = parameters[j] - step;
    const auto below = numbers_of(form, x, channels, true);
    x[j] = parameters[j];
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      J(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          (above[i].value - below[i].value) / (2 * step);
    }
  }
  return J;
}

}  // namespace gonio::fit
