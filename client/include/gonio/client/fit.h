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

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gonio/client/material.h"
#include "gonio/fit/certificate.h"

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

// What is minimised, and by name: "l1", "l2", "huber", "log", "cbrt".
using gonio::fit::name_of;
using gonio::fit::Objective;
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

using FitProgress = gonio::fit::Progress;

// Both are called on the thread that called fit().
struct FitWatch {
  std::function<void(const FitProgress&)> progress;  // several times a second
  std::function<bool()> stop;  // asked about 20 times a second; true ends the fit with `cancelled`
};

// What the fit found, and how far it can be trusted.
using gonio::fit::Verdict;
using FitAlbedo = gonio::fit::Albedo;
using FitCertificate = gonio::fit::Certificate;
using FitErrors = gonio::fit::Errors;
using FitErrorsByZone = gonio::fit::ErrorsByZone;
using FitIndistinct = gonio::fit::Indistinct;
using FitLeftOut = gonio::fit::LeftOut;
using FitParameter = gonio::fit::ParameterReport;
using FitPlace = gonio::fit::Place;
using FitProfile = gonio::fit::Profile;
using FitRegion = gonio::fit::Region;
using FitRegions = gonio::fit::Regions;
using FitStage = gonio::fit::Stage;
using FitStart = gonio::fit::Start;

struct FitResult {
  Material material;
  FitCertificate certificate;
  std::string json;  // all of it, as gonio.v1.FitResult, its fields named as in the .proto
};

}  // namespace gonio::client
