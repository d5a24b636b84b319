#include "fit/report/material_numbers.h"

#include <algorithm>
#include <cmath>

#include "fit/linear/basis.h"
#include "gonio/engine/registry.h"

namespace gonio::fit {
namespace {

// In a sum a lobe's own diffuse term is held at 0, and no result.
bool is_held(const FormLobe& lobe, const Parameter& p) {
  return lobe.columns == Columns::ashikhmin_shirley && lobe.coefficient_count < 3 && p.name == "rd";
}

void append_numbers(const FormLobe& lobe, const LobeSpec& spec, int channels,
                    std::vector<MaterialNumber>& to) {
  for (const Parameter& p : (*find_model(spec.model))->parameters) {
    const auto found = spec.parameters.find(p.name);
    if (p.type == ParameterType::word || found == spec.parameters.end() || is_held(lobe, p))
      continue;
    const auto& numbers = std::get<std::vector<double>>(found->second);
    const bool shared = p.type == ParameterType::number || p.name == "eta" || p.name == "k";
    for (int c = 0; c < (shared ? 1 : channels); ++c) {
      const double value = numbers[numbers.size() == 1 ? 0 : static_cast<std::size_t>(c)];
      to.push_back({lobe.prefix + "parameters." + std::string(p.name), shared ? -1 : c, value, &p});
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
