// From a material on the wire to one that can be evaluated.
#pragma once

#include <string>
#include <string_view>

#include "gonio/base/result.h"
#include "gonio/engine/material.h"
#include "gonio/v1/material.pb.h"

namespace gonio::server {

// Whether its model is one whose parameters name a file.
bool is_measured(const v1::Material& material);

// Builds a model, a sum or a measured file: everything but {"name": ...}. Without
// `find_file` files are not offered at all. Errors name the field with `prefix` before it, such as
// "material.parameters.alpha_x". Thread safety: a function without state.
Result<Material> build_material(const v1::Material& material, std::string_view prefix,
                                const FindFile& find_file);

// What a model or a sum says, unchecked but for its form. Errors as above.
Result<MaterialSpec> material_spec(const v1::Material& material, std::string_view prefix);

}  // namespace gonio::server
