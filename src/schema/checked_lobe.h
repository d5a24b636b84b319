// The checked parameters of one lobe: what a part of a material is made of.
#pragma once

#include <cstddef>
#include <string_view>

#include "gonio/models/description.h"
#include "schema/parameter_values.h"

namespace gonio {

struct CheckedLobe {
  const ModelDescription* model;
  // Which combination of the model's words: counted in the order of its table, the last word the
  // fastest.
  std::size_t kind;
  ParameterValues<double> values;  // of the model's table, and the material's rotation
};

// The word of the parameter `name`, as the lobe's kind has it; empty if the model has no such word.
inline std::string_view word_of(const CheckedLobe& lobe, std::string_view name) {
  std::size_t kind = lobe.kind;
  const auto& parameters = lobe.model->parameters;
  for (std::size_t i = parameters.size(); i-- > 0;) {
    if (parameters[i].type != ParameterType::word) continue;
    const std::size_t words = parameters[i].words.size();
    if (parameters[i].name == name) return parameters[i].words[kind % words];
    kind /= words;
  }
  return {};
}

}  // namespace gonio
