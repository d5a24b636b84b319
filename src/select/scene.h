// What a scene asks of a material: the pairs of directions that it looks at, how far off a value
// may be, and what counts as cost.
//
// Thread safety: plain data.
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include "fit/linear/objective.h"
#include "gonio/base/result.h"

namespace gonio::select {

// The error that the tolerance is of, with cos that of incidence; fit/report/metrics.h has the
// formulas.
enum class Metric : std::uint8_t {
  l1,    // |f - m| cos, as a part of m cos
  rmse,  // of f cos, in 1/sr
  log,   // of log(1 + f cos)
  cbrt,  // of the cube root of f cos
  // CIEDE2000, the mean over the picture of a sphere; of one channel or three. See picture.h.
  delta_e,
};
fit::Objective objective_of(Metric metric);  // what a fit minimises for it

enum class CostKind : std::uint8_t {
  ns,           // time of an evaluation
  bytes,        // memory that the prepared material holds
  ns_variance,  // ns times 1 + variance / mean^2 of a sample's weight; see cost.h
};

enum class Lights : std::uint8_t {
  directional,  // theta_i are the angles at which they stand
  environment,  // light from everywhere: theta_i goes from 0 to the horizon
};

struct Range {
  double lower = 0, upper = 0;  // radians
};

// Pairs of directions, even per solid angle within the ranges. phi is the angle between the
// azimuths, 0 to pi: pi where wo is on the mirror's side. How a pair as a whole is turned about the
// normal is even, too.
struct Bin {
  Range theta_i, theta_o;
  Range phi{0, std::numbers::pi};
  double weight = 1;  // how often such pairs occur; of all bins, any unit
};

inline constexpr std::size_t kMostBins = 50'000;  // 36 x 36 x 36 and some

struct Scene {
  std::vector<Bin> bins;  // one for plain ranges, many for a histogram that a renderer logged
  Lights lights = Lights::directional;
  bool anisotropy = true;  // does it matter? Otherwise only isotropic candidates are tried
  Metric metric = Metric::l1;
  double tolerance = 0;      // of the metric
  double confidence = 0.95;  // that the error is below it
  CostKind cost = CostKind::ns;
};

// Is it a scene? Errors name the field: "scene.theta_i", or "scene.bins[3].theta_i" of several;
// angles are printed in degrees.
Outcome check(const Scene& scene);

// A histogram's bins from its edges (radians, ascending) and its counts, [theta_i][theta_o][phi];
// bins of count 0 are left out. Errors: lengths or edges, as "scene.histogram....".
Result<std::vector<Bin>> bins_of(const std::vector<double>& theta_i,
                                 const std::vector<double>& theta_o, const std::vector<double>& phi,
                                 const std::vector<double>& counts);

}  // namespace gonio::select
