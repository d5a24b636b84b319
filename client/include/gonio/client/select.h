// What Client::select takes and gives: a reference and what a scene needs in, the cheapest material
// that is good enough out, with all others that were tried.
//
//   SelectScene scene;
//   scene.bins = {{.theta_i = {0, 1.3}, .theta_o = {0, 1.3}}};
//   scene.tolerance = 0.05;
//   auto result = client.select(Material::named("nickel"), scene);
//   if (result && result->choice) std::puts(result->choice->material->to_json().c_str());
//
// Thread safety: plain values.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gonio/client/fit.h"
#include "gonio/client/material.h"
#include "gonio/select/selection.h"

namespace gonio::client {

// The error that the tolerance is of; FitErrors has the formulas. delta_e is CIEDE2000, the mean
// over the picture of a sphere in which a white diffuser that faces the light is white; of one
// channel or three, which are linear sRGB.
enum class SelectMetric : std::uint8_t { l1, rmse, log, cbrt, delta_e };

enum class SelectCost : std::uint8_t {
  ns,           // time of an evaluation
  bytes,        // memory that the prepared material holds
  ns_variance,  // ns times 1 + variance / mean^2 of a sample's weight, for environments
};

enum class SelectLights : std::uint8_t { directional, environment };

// By their names: "l1", "ns_variance", "environment". Errors name the field, "scene.metric", and
// what is known.
Result<SelectMetric> metric_of(std::string_view name);
Result<SelectCost> cost_of(std::string_view name);
Result<SelectLights> lights_of(std::string_view name);

struct SelectRange {
  double lower = 0, upper = 0;  // radians
};

// Pairs of directions, even per solid angle within the ranges; phi is the angle between the
// azimuths, pi where wo is on the mirror's side.
struct SelectBin {
  SelectRange theta_i, theta_o;
  SelectRange phi{0, std::numbers::pi};
  double weight = 1;  // how often such pairs occur; of all bins, any unit
};

struct SelectScene {
  std::vector<SelectBin> bins;  // one for plain ranges, many for a histogram
  SelectLights lights = SelectLights::directional;
  bool anisotropy = true;  // does it matter? Otherwise only isotropic candidates are tried
  SelectMetric metric = SelectMetric::l1;
  double tolerance = 0;      // above 0, of the metric
  double confidence = 0.95;  // that the error is below it
  SelectCost cost = SelectCost::ns;
};

// A material, itself the last candidate; or at least 200 measured pairs within the scene's angles.
using SelectReference = std::variant<Material, FitData>;

struct SelectOptions {
  bool whole_front = true;  // false: what costs more than the choice is not fitted
  unsigned lobes = 2;       // at most so many specular ones, 1 or 2
  // Nanoseconds of parts by name, such as "ggx:schlick"; empty: measured by the server.
  std::map<std::string, double, std::less<>> costs;
  // Pairs that candidates are fitted to, compared by and certified by, 100 to 1,000,000 each.
  unsigned fitted = 4000, validation = 8192, certification = 16384;
  unsigned starts = 3;     // of each fit, 1 to 100
  std::uint64_t seed = 1;  // of the choice of pairs, 1 or more
  // In place of ClientOptions::deadline.
  std::optional<std::chrono::milliseconds> deadline;
};

using SelectProgress = gonio::select::Progress;

// Both are called on the thread that called select().
struct SelectWatch {
  std::function<void(const SelectProgress&)> progress;  // several times a second
  std::function<bool()> stop;  // asked about 20 times a second; true ends it with `cancelled`
};

// What was tried, and what is chosen.
using SelectError = gonio::select::Bounded;
using SelectEntry = gonio::select::EntryOf<Material>;
using SelectChoice = gonio::select::ChoiceOf<Material>;
struct Selection : gonio::select::SelectionOf<Material> {
  std::string json;  // all of it, as gonio.v1.SelectResult, its fields named as in the .proto
};

}  // namespace gonio::client
