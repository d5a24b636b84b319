// From checked parameter values to the constants that a kernel reads.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "engine/kernels/constants.h"
#include "gonio/models/description.h"
#include "schema/parameter_values.h"

namespace gonio {

struct PreparedLobe {
  std::size_t kernel;                     // index into KernelTable::analytic
  std::shared_ptr<const void> constants;  // a Constants<Kind>
  std::size_t bytes;                      // of the constants
};

// `model` is one of models(), not the measured one; `kind` counts the combinations of the model's
// word parameters, in the order of its table, the last word the fastest.
PreparedLobe prepare(const ModelDescription& model, std::size_t kind,
                     const ParameterValues<double>& values, int channels);

// The same for the derivative by the parameter `by`: a Constants<Kind, Dual<double>>.
PreparedLobe prepare_derivative(const ModelDescription& model, std::size_t kind,
                                const ParameterValues<double>& values, int channels,
                                std::string_view by);

// The same in long double, for truth: a Constants<Kind, LongDouble>.
PreparedLobe prepare_extended(const ModelDescription& model, std::size_t kind,
                              const ParameterValues<double>& values, int channels);

}  // namespace gonio
