// The keys of a material's JSON, checked by name before protobuf's parser sees them: it says only
// that it cannot find a field. Thread safety: a function without state.
#pragma once

#include <string_view>

#include "gonio/base/result.h"

namespace gonio::wire {

// Errors: a key that the message does not have, with those that it has and the nearest of them.
// What is no JSON object at all is left to the parser.
Outcome check_material_keys(std::string_view json);

}  // namespace gonio::wire
