// What a fit reports beside its material: how it came about, and how far it can be trusted.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "fit/linear/objective.h"
#include "fit/report/metrics.h"

namespace gonio::fit {

enum class Verdict : std::uint8_t {
  converged,      // one optimum, inside the bounds, and the data determine it
  bound_limited,  // a bound of the model's table holds the optimum
  ambiguous,      // other parameters fit as well: the data cannot tell
  failed,         // there is nothing to fit, or no descent ended
};
std::string_view name_of(Verdict verdict);  // "converged", "bound-limited", "ambiguous", "failed"

struct Stage {
  std::string name;
  double objective = 0;  // on the pairs of this stage, as a part of that of f = 0
  std::size_t pairs = 0;
  int iterations = 0;
  double cpu_seconds = 0;
};

// One descent on the scan's pairs, by its shape parameters (in the order of Certificate::shapes).
struct Start {
  bool given = false;  // the caller's guess; else a node of the scan, or the models' own start
  std::vector<double> from, to;
  double objective = 0;
  bool agrees = false;  // within 1 % of the best
};

struct ParameterReport {
  std::string field;  // "specular[0].parameters.eta"
  int channel = -1;   // -1: shared by all
  double value = 0, standard_error = 0;
  bool at_bound = false;   // of the model's table; it has no standard error then
  bool determined = true;  // false: the data say nothing of it; the interval is its whole range
  double lower = 0, upper = 0;  // 95 % interval; for a logarithmic parameter symmetric in its log
};

// Parameters that can move together and the data hardly mind: by an eigenvector of the curvature
// (scaled to a unit diagonal) with next to no curvature, or two of a material's numbers whose
// estimates go together: their own matrix has the eigenvalue 1 - |correlation|. Numbers that the
// fit holds equal, alpha_x and alpha_y of an isotropic material, are none of these.
struct Indistinct {
  std::vector<std::string> fields;
  double eigenvalue = 0;
  std::optional<double> correlation;  // of two numbers; none for an eigenvector
};

// Where a parameter can be, the others following, with an objective within 1 % of the best.
struct Profile {
  std::string field;
  double lower = 0, upper = 0;
  double part = 0;        // of the range that is searched
  bool separate = false;  // are there worse values in between?
};

struct Albedo {
  double theta = 0;  // radians, of incidence
  std::vector<double> channels;
};

struct Certificate {
  Verdict verdict = Verdict::failed;
  std::string reason;
  Objective objective = Objective::l1;
  std::size_t pairs = 0;  // of the data, after what was left out
  LeftOut left_out;
  std::vector<std::string> shapes;  // fields of the shared parameters
  std::vector<Stage> stages;
  std::vector<Start> starts;
  std::size_t agreeing = 0;  // starts within 1 % of the best
  double gradient_norm = 0;  // of the free parameters, each scaled by its own curvature
  std::vector<ParameterReport> parameters;
  std::vector<std::string> active_bounds;
  std::vector<Indistinct> indistinct;
  std::vector<Profile> profiles;
  ErrorsByZone errors;  // on all data, whatever was fitted
  std::vector<Place> worst;
  Regions regions;
  std::vector<Albedo> albedo;
  double cpu_seconds = 0;
};

}  // namespace gonio::fit
