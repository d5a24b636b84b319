// What a scene needs, as people and renderers write it; and prices. Thread safety: no state.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/client/select.h"

namespace gonio::cli {

// A material of a scene.
struct SceneMaterial {
  std::string name;       // empty: the only one, of the command line
  std::string reference;  // as --reference takes it
  client::SelectScene needs;
};

// A JSON file such as
//
//   {"theta_i": [0, 75], "theta_o": [0, 75], "lights": "directional", "tolerance": 0.05,
//    "materials": {"car": {"reference": "car.binary"}, "road": {"reference": "road.binary",
//                          "tolerance": 0.2}}}
//
// Angles are in degrees. `gonio select --help` lists the fields. What a material says itself takes
// the place of what is said of all; its files are looked for beside the scene's. With a `reference`
// from the command line that is the only material, and the file may not have others. Errors name
// the field, its value and what is allowed; what is in the file but no field is an error, too.
Result<std::vector<SceneMaterial>> read_scene(const std::string& file,
                                              const std::string& reference);

// {"lambertian": 1.0, "ggx:schlick": 4.4, ...}: nanoseconds by part.
Result<std::map<std::string, double, std::less<>>> read_costs(const std::string& file);

// Says of which material an error is.
Error of_material(const std::string& name, Error error);

}  // namespace gonio::cli
