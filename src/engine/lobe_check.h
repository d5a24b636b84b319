// Checking one lobe's parameters against its model's table.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "engine/material.h"
#include "engine/number_check.h"
#include "models/description.h"
#include "models/parameter_values.h"

namespace gonio {

struct NamedLobe {
  const LobeSpec* spec;
  std::string prefix;           // of its fields, in errors
  std::optional<Role> must_be;  // its place in a sum
};

struct CheckedLobe {
  const ModelDescription* model;
  std::size_t kind;  // see prepare()
  ParameterValues<double> values;
};

Result<CheckedLobe> check_lobe(const NamedLobe& lobe, ChannelCount& channels);

}  // namespace gonio
