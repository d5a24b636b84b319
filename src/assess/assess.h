// Shows where a material fails: the errors of its values at the places where methods are known to
// fail, beside those of naive arithmetic; its energy and its samples by incidence; and a verdict by
// the caller's limits.
//
// Some tenths of a second to a few seconds of one thread. Thread safety: a function without state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "assess/report.h"
#include "gonio/base/result.h"
#include "gonio/engine/isa.h"
#include "gonio/engine/sampler.h"

namespace gonio::assess {

// The probability that a good material fails by the random choice of its samples. The default
// limits of the checks of samples share it among all incidences and channels.
inline constexpr double kFalseAlarms = 1e-3;

// A table's cells are up to 2 degrees of theta_h and 1 of theta_d wide: nearer to the horizon than
// both together, each lookup uses cells that the horizon cuts, and interpolates values that grow as
// 1 / cos. An albedo there is an artefact of the interpolation.
inline constexpr double kUncut = 87;

// The limits of the checks. Values that are NaN, infinite or negative, and light where there should
// be none, always fail.
struct Limits {
  // Relative errors of the two precisions; if not given, the bounds that the material states.
  std::optional<double> error, reference_error;
  std::optional<double> reciprocity;  // if not given, twice the bound of Precision::fast
  // Albedo above 1; if not given, 1e-3, of a table for light within kUncut degrees of the normal.
  std::optional<double> gain;
  double loss = 1;                     // albedo below 1; 1: any
  double mass = 5e-3;                  // |integral of the pdf + lost mass - 1|
  std::optional<double> weight_error;  // if not given, the bound of Precision::fast and 4 roundings
  std::optional<double> probability;   // the least probability of the samples by chi-square; if not
                                       // given, from kFalseAlarms
  std::optional<double>
      deviation;  // the largest Incidence::deviation; if not given, from kFalseAlarms
  // Of a table's cells (measured/merl/review.h).
  double missing = 0.1;         // share without a measurement
  double missing_region = 0.5;  // the same in the worst range of an angle
  double zeros = 0.5;           // share of cells that hold 0, in the worst channel
  double holes = 1e-3;          // share of masked cells
  double outlier = 100;         // times as bright as the neighbouring cells
  double extreme = 1e5;         // f cos(theta_i) cos(theta_o), 1/sr
};

struct Options {
  Limits limits;
  std::size_t pairs = 4000;  // at each place, up to kMostPairs
  std::uint64_t seed = 1;
};
inline constexpr std::size_t kMostPairs = 1'000'000;

// Errors: options out of bounds, by field ("limits.gain"); cancelled, as soon as `stop`, which is
// called some hundred times a second, returns true.
Result<Report> assess(const Sampler& sampler, const Options& options, Isa isa,
                      const std::function<bool()>& stop = {});
// The same for a subject, in which a test may have planted a fault.
Result<Report> assess(const Subject& subject, const Options& options,
                      const std::function<bool()>& stop = {});

// The approximate memory that an assessment holds, in bytes.
std::size_t memory_of(int channels, const Options& options);

}  // namespace gonio::assess
