// What Client::fit takes and gives: measured reflectance in, a material and its certificate out.
//
//   FitData data{.wi = wi, .wo = wo, .values = values, .channels = 3};
//   auto form = Material::sum(Lobe{"lambertian", {}}, {Lobe{"ggx", {{"fresnel", "schlick"}}}});
//   auto result = client.fit(data, form);
//   if (result) std::puts(result->material.to_json().c_str());
//
// Directions as for evaluation; values in 1/sr, without a cosine, all channels of the first pair,
// then of the second. Entries that are not finite, not unit, below the horizon, negative or without
// weight are left out and counted. Thread safety: plain values.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gonio/client/material.h"

namespace gonio::client {

// Either pairs, or a measured material of the server's.
struct FitData {
  std::span<const float> wi, wo;  // xyz of each pair
  std::span<const float> values;  // pairs x channels
  int channels = 0;               // 1 to 64
  // The measure, in sr^2, of the pairs of directions that each stands for; all over the hemisphere
  // together measure 4 pi^2. Empty: each weighs the same.
  std::span<const float> weights;
  std::optional<Material> measured;  // in place of all of the above
};

// With cos the cosine of incidence and m what was measured, what is minimised is the weighted sum
// of:
enum class Objective : std::uint8_t {
  l1,     // |f - m| cos
  l2,     // its square
  huber,  // Huber's function of it
  log,    // |log(1 + f cos) - log(1 + m cos)|
  cbrt,   // the squared difference of the cube roots of f cos and m cos
};
std::string_view name_of(Objective objective);  // "l1", "l2", "huber", "log", "cbrt"
std::optional<Objective> objective_of(std::string_view name);

enum class FitStrategy : std::uint8_t {
  automatic,  // a scan of the shapes, descents from its most distinct places, the best on more
              // pairs
  staged,     // Nielsen et al. 2014: colours; then shapes; then lobes; from one guess
};

struct FitOptions {
  Objective objective = Objective::l1;
  FitStrategy strategy = FitStrategy::automatic;
  // nu and nv, alpha_x and alpha_y each by themselves, and along which axes: the material's
  // rotation is found, too, unless the form has one (Material::rotated).
  bool anisotropic = false;
  bool cosine = true;    // false: of f in place of f cos
  double huber = 0.1;    // Huber's threshold, as a part of the mean of m cos
  double min_theta = 0;  // radians; pairs whose larger angle is in (min, max] are fitted
  double max_theta = 1.5707963267948966;
  unsigned starts = 6;                              // places that are descended from
  unsigned fit_pairs = 20'000, scan_pairs = 2'000;  // of the stratified subsets
  bool polish = false;                              // a last descent on all pairs
  std::uint64_t seed = 1;                           // of the subsets, 1 or more
  // In place of ClientOptions::deadline.
  std::optional<std::chrono::milliseconds> deadline;
};

struct FitProgress {
  std::string stage;  // "queued", "data", "scan", "starts", "fit", "polish"
  int iteration = 0;
  double objective = 0;  // at present, as a part of that of f = 0
  double best = 0;       // in this stage so far
};

// Both are called on the thread that called fit().
struct FitWatch {
  std::function<void(const FitProgress&)> progress;  // several times a second
  std::function<bool()> stop;  // asked about 20 times a second; true ends the fit with `cancelled`
};

enum class Verdict : std::uint8_t {
  unknown,        // of a newer server
  converged,      // one optimum, inside the bounds, and the data determine it
  bound_limited,  // a bound of a parameter holds the optimum
  ambiguous,      // other parameters fit as well: the data cannot tell
  failed,         // nothing to fit, the model has not what the data have, or no descent ended
};
std::string_view name_of(Verdict verdict);  // "converged", "bound-limited", "ambiguous", "failed"

struct FitLeftOut {
  std::uint64_t not_finite = 0, not_unit = 0, below_horizon = 0, negative = 0, no_weight = 0;
};

struct FitStage {
  std::string name;
  double objective = 0;  // on this stage's pairs, as a part of that of f = 0
  std::uint64_t pairs = 0;
  int iterations = 0;
  double cpu_seconds = 0;
};

struct FitStart {
  bool given = false;            // the caller's guess; otherwise a place of the scan
  std::vector<double> from, to;  // in the order of FitCertificate::shapes
  double objective = 0;
  bool agrees = false;  // within 1 % of the best
};

struct FitParameter {
  std::string field;  // "specular[0].parameters.eta"
  int channel = -1;   // -1: shared by all
  double value = 0, standard_error = 0;
  bool at_bound = false;
  double lower = 0, upper = 0;  // the 95 % interval
  // The data say nothing of it: no standard error, and the interval is its whole range.
  bool undetermined = false;
};

// Parameters that can move together, and the data hardly mind.
struct FitIndistinct {
  std::vector<std::string> fields;
  // Of the curvature scaled to a unit diagonal; for two numbers whose estimates go together,
  // 1 - |correlation|.
  double eigenvalue = 0;
};

// Where a parameter can be, the others following, with an objective within 1 % of the best.
struct FitProfile {
  std::string field;
  double lower = 0, upper = 0;
  double part = 0;        // of the range that is searched
  bool separate = false;  // there are worse values in between
};

// Sums over pairs and channels, w a pair's weight, m measured.
struct FitErrors {
  double l1 = 0;    // sum w |f - m| cos / sum w m cos
  double rmse = 0;  // sqrt(sum w ((f - m) cos)^2 / sum w), in 1/sr
  double log = 0;   // sum w |log(1 + f cos) - log(1 + m cos)| / sum w
  double cbrt = 0;  // sqrt(sum w (cbrt(f cos) - cbrt(m cos))^2 / sum w)
  std::uint64_t pairs = 0;
};

// By the larger of both angles, in degrees.
struct FitErrorsByZone {
  FitErrors all, below_80, above_80;
};

// A pair at which the material is far off: its share of the sum of w |f - m| cos.
struct FitPlace {
  std::array<double, 3> wi{}, wo{};
  int channel = 0;
  double measured = 0, fitted = 0, share = 0;
};

// What is reflected in a region of directions, as parts of all that is measured; error: of |f - m|.
struct FitRegion {
  double measured = 0, fitted = 0, error = 0;
};

struct FitAlbedo {
  double theta = 0;  // radians, of incidence
  std::vector<double> channels;
};

struct FitCertificate {
  Verdict verdict = Verdict::unknown;
  std::string reason;
  std::uint64_t pairs = 0;  // of the data, without those left out
  FitLeftOut left_out;
  std::vector<FitStage> stages;
  std::vector<std::string> shapes;  // fields of the shared parameters
  std::vector<FitStart> starts;
  std::uint64_t agreeing = 0;  // starts within 1 % of the best
  double gradient_norm = 0;    // of the free parameters, each scaled by its own curvature
  std::vector<FitParameter> parameters;
  std::vector<std::string> active_bounds;
  std::vector<FitIndistinct> indistinct;
  std::vector<FitProfile> profiles;
  FitErrorsByZone errors;  // on all data, whatever was fitted
  std::vector<FitPlace> worst;
  FitRegion mirror, toward_light, elsewhere;  // within 25 degrees of the mirror; of the light; else
  std::vector<FitAlbedo> albedo;
  double cpu_seconds = 0;
};

struct FitResult {
  Material material;
  FitCertificate certificate;
  std::string json;  // all of it, as gonio.v1.FitResult, its fields named as in the .proto
};

}  // namespace gonio::client
