// The report of a fit beside its material: how it was found, and how far it can be trusted. The
// fit, the wire (proto/wire/mapping/certificate.h) and the client library use these structures.
// Thread safety: plain values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/fit/objective.h"

namespace gonio::fit {

struct Progress {
  std::string stage;  // "queued", "data", "scan", "starts", "fit", "polish", "certificate"
  int iteration = 0;
  double objective = 0;  // the current one, relative to that of f = 0
  double best = 0;       // the best in this stage so far
};

enum class Verdict : std::uint8_t {
  unknown,        // of a newer server; a fit never gives it
  converged,      // one optimum, inside the bounds, and the data determine it
  bound_limited,  // a bound of a parameter holds the optimum
  ambiguous,      // other parameters fit as well: the data do not decide
  failed,         // nothing to fit, the model lacks a lobe that the data show, or no descent ended
};
inline constexpr std::array<std::string_view, 5> kVerdictNames{
    "unknown", "converged", "bound-limited", "ambiguous", "failed"};

constexpr std::string_view name_of(Verdict verdict) {
  return kVerdictNames.at(static_cast<std::size_t>(verdict));
}

// Unusable entries, counted by the first reason that applies.
struct LeftOut {
  std::uint64_t not_finite = 0;     // a direction, a value or a weight that is NaN or infinite
  std::uint64_t not_unit = 0;       // a direction off unit length by more than 1e-3
  std::uint64_t below_horizon = 0;  // a direction at or below the horizon
  std::uint64_t negative = 0;       // a value below 0: MERL's mark of "not measured", or noise
  std::uint64_t no_weight = 0;      // a weight that is not above 0
  [[nodiscard]] std::uint64_t total() const {
    return not_finite + not_unit + below_horizon + negative + no_weight;
  }
};

struct Stage {
  std::string name;
  double objective = 0;  // on this stage's pairs, relative to that of f = 0
  std::uint64_t pairs = 0;
  int iterations = 0;
  double cpu_seconds = 0;
};

// One descent on the scan's pairs, by its shape parameters (in the order of Certificate::shapes).
struct Start {
  bool given = false;  // the caller's guess; otherwise a node of the scan, or the models' own start
  std::vector<double> from, to;
  double objective = 0;
  bool agrees = false;  // within 1 % of the best
};

struct ParameterReport {
  std::string field;  // "specular[0].parameters.eta"
  int channel = -1;   // -1: shared by all channels
  double value = 0, standard_error = 0;
  bool at_bound = false;        // of the model's table; it has no standard error then
  double lower = 0, upper = 0;  // 95 % interval; for a logarithmic parameter symmetric in its log
  // The data do not determine it: no standard error, and the interval is the whole range.
  bool undetermined = false;
};

// Parameters that can change together with little effect on the objective: an eigenvector of the
// curvature (scaled to a unit diagonal) with almost no curvature, or two numbers of a material with
// correlated estimates, whose own matrix has the eigenvalue 1 - |correlation|. Numbers that the fit
// holds equal, alpha_x and alpha_y of an isotropic material, do not count.
struct Indistinct {
  std::vector<std::string> fields;
  double eigenvalue = 0;
  std::optional<double> correlation;  // of two numbers; none for an eigenvector
};

// Where a parameter can be, the others following, with an objective within 1 % of the best.
struct Profile {
  std::string field;
  double lower = 0, upper = 0;
  double part = 0;        // share of the range that is searched
  bool separate = false;  // values in between are worse
};

// With w a pair's weight and cos that of incidence, sums over pairs and channels, m measured:
struct Errors {
  double l1 = 0;    // sum w |f - m| cos / sum w m cos
  double rmse = 0;  // sqrt(sum w ((f - m) cos)^2 / sum w), in 1/sr
  double log = 0;   // sum w |log(1 + f cos) - log(1 + m cos)| / sum w
  double cbrt = 0;  // sqrt(sum w (cbrt(f cos) - cbrt(m cos))^2 / sum w)
  std::uint64_t pairs = 0;
};

// Errors by the larger of both angles, in degrees.
struct ErrorsByZone {
  Errors all, below_80, above_80;
};

// A pair with a large error: its share of the sum of w |f - m| cos.
struct Place {
  std::array<double, 3> wi{}, wo{};
  int channel = 0;
  double measured = 0, fitted = 0, share = 0;
};

// Reflection in a region of directions, relative to all that is measured (w m cos).
struct Region {
  double measured = 0, fitted = 0, error = 0;  // error: w |f - m| cos
};

// By the place of wo: within 25 degrees of the mirror direction of wi; of the others, within 25
// degrees of wi; the rest.
struct Regions {
  Region mirror, toward_light, elsewhere;
};

struct Albedo {
  double theta = 0;  // the angle of incidence, radians
  std::vector<double> channels;
};

struct Certificate {
  Verdict verdict = Verdict::failed;
  std::string reason;
  std::optional<Objective> objective;  // the one minimised; none: one of a newer server
  std::uint64_t pairs = 0;             // of the data, without those left out
  LeftOut left_out;
  std::vector<std::string> shapes;  // fields of the shared parameters
  std::vector<Stage> stages;
  std::vector<Start> starts;
  std::uint64_t agreeing = 0;  // starts within 1 % of the best
  double gradient_norm = 0;    // of the free parameters, each scaled by its own curvature
  std::vector<ParameterReport> parameters;
  std::vector<std::string> active_bounds;
  std::vector<Indistinct> indistinct;
  std::vector<Profile> profiles;
  ErrorsByZone errors;  // over all data, whichever pairs were fitted
  std::vector<Place> worst;
  Regions regions;
  std::vector<Albedo> albedo;
  double cpu_seconds = 0;
};

}  // namespace gonio::fit
