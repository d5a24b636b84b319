// Checking one lobe's parameters against its model's table.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/material/number_check.h"
#include "gonio/base/result.h"
#include "gonio/engine/material.h"
#include "gonio/models/description.h"
#include "schema/checked_lobe.h"

namespace gonio {

struct NamedLobe {
  const LobeSpec* spec;
  std::string prefix;           // of its fields, in errors
  std::optional<Role> must_be;  // its place in a sum
};

Result<CheckedLobe> check_lobe(const NamedLobe& lobe, ChannelCount& channels);

// The same of a measured model, which is read from a file.
Result<CheckedLobe> check_measured(const NamedLobe& lobe);

}  // namespace gonio
