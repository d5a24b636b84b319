// The models that gonio knows, by name. Thread safety: constant data.
#pragma once

#include <span>
#include <string_view>

#include "gonio/base/result.h"
#include "gonio/models/description.h"

namespace gonio {

// All models, in the order of the registry.
std::span<const ModelDescription> models();

// The model called `name`; not_found with the names that exist otherwise.
Result<const ModelDescription*> find_model(std::string_view name);

}  // namespace gonio
