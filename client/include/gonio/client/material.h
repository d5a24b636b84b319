// What to evaluate: a material that the server holds, one model with parameters, or a sum of lobes.
//
// Nothing is checked here but the JSON's shape: the server knows the models and their bounds, and
// says what is wrong. Thread safety: plain values.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "gonio/base/result.h"

namespace gonio::client {

// A number, one number per colour channel, or a word such as "conductor".
using ParameterValue = std::variant<double, std::vector<double>, std::string>;
using Parameters = std::map<std::string, ParameterValue, std::less<>>;

struct Lobe {
  std::string model;
  Parameters parameters;
};

class Material {
 public:
  // A material that the server holds.
  static Material named(std::string_view name);

  // One model, e.g. Material::model("ggx", {{"f0", std::vector{1.0, 0.71, 0.29}}, {"alpha_x", 0.2},
  // {"alpha_y", 0.2}}).
  static Material model(std::string_view name, const Parameters& parameters = {});

  // At most one diffuse base and up to four specular lobes.
  static Material sum(const std::optional<Lobe>& diffuse, const std::vector<Lobe>& specular);

  // The same as people write it:
  //   {"name": "brushed-metal"}
  //   {"model": "ggx", "parameters": {"f0": [1, 0.71, 0.29], "alpha_x": 0.2, "alpha_y": 0.2}}
  //   {"diffuse": {"model": "lambertian", "parameters": {"rd": 0.2}}, "specular": [{"model": ...,
  //   "parameters": ...}]}
  // each with a "rotation": 30 beside if its tangents are turned.
  // Errors: invalid_argument for what is not JSON or not of this shape.
  static Result<Material> from_json(std::string_view json);

  // The same with its tangents turned about the normal, in degrees from -180 to 180,
  // counter-clockwise seen from above: "rotation" in the JSON. In the place of what it had; a
  // stored material is turned further.
  [[nodiscard]] Material rotated(double degrees) const;

  // One line of the JSON above.
  [[nodiscard]] std::string to_json() const;

  // The serialised gonio.v1.Material.
  [[nodiscard]] const std::string& wire() const { return wire_; }

 private:
  explicit Material(std::string wire) : wire_(std::move(wire)) {}
  std::string wire_;
};

}  // namespace gonio::client
