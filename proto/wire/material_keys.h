// Checks the keys of a material's JSON before protobuf's parser, whose message says only that a
// field was not found. Thread safety: a function without state.
#pragma once

#include <string_view>

#include "gonio/base/result.h"

namespace gonio::wire {

// Errors: a key that the message does not have; the error lists those that it has, and suggests the
// nearest. Text that is no JSON object is left to the parser.
Outcome check_material_keys(std::string_view json);

}  // namespace gonio::wire
