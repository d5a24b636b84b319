// Checking one lobe's parameters against its model's table.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/material/number_check.h"
#include "gonio/base/result.h"
#include "gonio/engine/material.h"
#include "gonio/models/description.h"
#include "schema/parameter_values.h"

namespace gonio {

struct NamedLobe {
  const LobeSpec* spec;
  std::string prefix;           // of its fields, in errors
  std::optional<Role> must_be;  // its place in a sum
};

struct CheckedLobe {
  const ModelDescription* model;
  std::size_t kind;                // see prepare()
  ParameterValues<double> values;  // of the model's table, and the material's rotation
};

// The word of the parameter `name`, as its kind has it; empty if the model has no such word.
std::string_view word_of(const CheckedLobe& lobe, std::string_view name);

// Whether what is used with some words has a meaning with the lobe's.
bool is_used(const CheckedLobe& lobe, const UsedWith& with);

// The first parameter of a quantity that is used with the lobe's words; null if there is none.
const Parameter* find_used(const CheckedLobe& lobe, Quantity quantity);

Result<CheckedLobe> check_lobe(const NamedLobe& lobe, ChannelCount& channels);

}  // namespace gonio
