// Checking the numbers of one parameter, or the name that stands for them.
#pragma once

#include <string>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/engine/material.h"
#include "gonio/models/description.h"

namespace gonio {

// The common length of the colour parameters seen so far, and which one set it.
struct ChannelCount {
  int count = 1;
  std::string set_by;
};

// What `given` says: its numbers, or those of the preset that it names. `field` names it in errors.
Result<std::vector<double>> check_numbers(const std::string& field, const Parameter& p,
                                          const ParameterValue& given, ChannelCount& channels);

}  // namespace gonio
