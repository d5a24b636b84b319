// The checked parameters of one lobe: what a part of a material is made of.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
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
  std::string file = {};           // what its parameter of the type file says
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

inline bool has_word(const UsedWith& with, std::string_view word) {
  return std::find(with.words.begin(), with.words.end(), word) != with.words.end();
}

// Whether what is used with some words has a meaning with the lobe's.
inline bool is_used(const CheckedLobe& lobe, const UsedWith& with) {
  return with.parameter.empty() || has_word(with, word_of(lobe, with.parameter));
}

// The first parameter of a quantity that is used with the lobe's words; null if there is none.
inline const Parameter* find_used(const CheckedLobe& lobe, Quantity quantity) {
  for (const Parameter& p : lobe.model->parameters) {
    if (quantity_of(p, lobe.model->role) == quantity && is_used(lobe, p.used_with)) return &p;
  }
  return nullptr;
}

}  // namespace gonio
