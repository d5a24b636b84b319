// Which parameters of a checked lobe have a meaning with its words.
#pragma once

#include <algorithm>
#include <string_view>

#include "gonio/models/description.h"
#include "schema/checked_lobe.h"

namespace gonio {

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
