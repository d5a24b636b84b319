// Where does a material fail? Its values at the places where methods are known to fail, held
// against truth, and beside what naive arithmetic gives there; its energy and its samples by
// incidence; and a verdict by limits of the caller's.
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

// How often a good material may fail for the choice of its samples alone: the limits of the checks
// of samples, where they are not given, share this among all that is looked at (each incidence,
// each channel).
inline constexpr double kFalseAlarms = 1e-3;

// A table's cells are up to 2 degrees of theta_h and 1 of theta_d wide: nearer to the horizon than
// both together each lookup is among cells that the horizon cuts, and between the centres of those
// above it values are carried on that grow as 1 / cos. An albedo there is interpolation's.
inline constexpr double kUncut = 87;

// What is still allowed. No value is ever allowed to be NaN, infinite or negative, nor light where
// there is none.
struct Limits {
  // Relative errors of the precisions; if not given, the bounds that the material states.
  std::optional<double> error, reference_error;
  std::optional<double> reciprocity;  // if not given, twice the bound of Precision::fast
  // Albedo above 1; if not given, 1e-3, of a table for light within kUncut degrees of the normal.
  std::optional<double> gain;
  double loss = 1;                     // albedo below 1; 1: any
  double mass = 5e-3;                  // |integral of the pdf + lost mass - 1|
  std::optional<double> weight_error;  // if not given, the bound of Precision::fast and 4 roundings
  std::optional<double> probability;   // the least of chi-square; if not given, by kFalseAlarms
  std::optional<double> deviation;     // Incidence::deviation; if not given, by kFalseAlarms
  // Of a table's cells (measured/merl/review.h).
  double missing = 0.1;         // share without a measurement
  double missing_region = 0.5;  // the same of the worst range of an angle
  double zeros = 0.5;           // share that holds 0, of the worst channel
  double holes = 1e-3;          // share of masked ones
  double outlier = 100;         // times as bright as what is about them
  double extreme = 1e5;         // f cos(theta_i) cos(theta_o), 1/sr
};

struct Options {
  Limits limits;
  std::size_t pairs = 4000;  // at each place, up to kMostPairs
  std::uint64_t seed = 1;
};
inline constexpr std::size_t kMostPairs = 1'000'000;

// Errors: options out of bounds, by field ("limits.gain"); cancelled, as soon as `stop`, asked some
// hundred times a second, says so.
Result<Report> assess(const Sampler& sampler, const Options& options, Isa isa,
                      const std::function<bool()>& stop = {});
// The same of a material as a test may have broken it.
Result<Report> assess(const Subject& subject, const Options& options,
                      const std::function<bool()>& stop = {});

// Memory that an assessment holds, about.
std::size_t memory_of(int channels, const Options& options);

}  // namespace gonio::assess
