// Substances as materials: a preset's name where a material's is expected. Thread safety: functions
// without state.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/v1/material.pb.h"

namespace gonio::server {

// A surface of GGX microfacets of the substance, all else as when it is not given: of a conductor
// by its complex index, else by its reflectance at normal incidence. None where there is no such
// preset.
std::optional<v1::Material> preset_material(std::string_view name);

// The substances' names, sorted.
std::vector<std::string> preset_names();

}  // namespace gonio::server
