// What a scene needs, as people and renderers write it; and prices. Thread safety: no state.
#pragma once

#include <string>

#include "base/result.h"
#include "select/cost.h"
#include "select/scene.h"

namespace gonio::cli {

// A JSON file such as
//
//   {"theta_i": [0, 75], "theta_o": [0, 75], "lights": "directional", "tolerance": 0.05}
//
// Angles are in degrees. `gonio select --help` lists the fields. Errors name the field, its value
// and what is allowed; what is in the file but no field is an error, too.
Result<select::Scene> read_scene(const std::string& file);

// {"lambertian": 1.0, "ggx:schlick": 4.4, ...}: nanoseconds by part.
Result<select::CostTable> read_costs(const std::string& file);

}  // namespace gonio::cli
