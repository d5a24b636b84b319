// The numbers of a fitted material, as a person reads them, and how they follow from the fit's
// parameters.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "fit/form.h"
#include "gonio/models/description.h"

namespace gonio::fit {

struct MaterialNumber {
  std::string field;
  int channel;  // -1: of all
  double value;
  const Parameter* parameter;
};

// In the order of the material's lobes and their tables; words and colours that the fit does not
// touch are left out. `exact` as to_material() has it.
std::vector<MaterialNumber> numbers_of(const Form& form, std::span<const double> parameters,
                                       int channels, bool exact = false);

// What these numbers change by with the fit's parameters: a row a number, by central differences.
Eigen::MatrixXd slopes_of(const Form& form, std::span<const double> parameters, int channels,
                          const std::vector<MaterialNumber>& numbers);

}  // namespace gonio::fit
