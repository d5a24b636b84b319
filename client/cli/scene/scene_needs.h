// What a scene asks of a material, from JSON. Thread safety: a function without state.
#pragma once

#include <array>
#include <string_view>

#include "client/cli/scene/json_fields.h"
#include "gonio/base/result.h"
#include "gonio/client/select.h"

namespace gonio::cli {

inline constexpr std::array<std::string_view, 11> kNeedFields{
    "theta_i", "theta_o", "phi",       "histogram",  "lights", "anisotropy",
    "time",    "metric",  "tolerance", "confidence", "cost"};
// Those that a histogram stands in the place of.
inline constexpr std::array<std::string_view, 3> kRangeFields{"theta_i", "theta_o", "phi"};

// From an object's fields of these names; others are not looked at. Whether what they say is a
// scene, such as a tolerance above 0, the service says. Errors: "scene.theta_i", ...
Result<client::SelectScene> scene_needs(const JsonObject& object);

}  // namespace gonio::cli
