// Charts of speed against accuracy: measures on this machine every choice that trades one for the
// other. Each part gives a table (chart/table.h), in which 1 in the column "front" marks the rows
// that no other one beats.
//
//   chart::Options options;
//   auto models = chart::chart_models(options);  // models x precision x instruction set
//
// tests/bench times the same cases (chart/cases.h) with the same code (timing/race.h). A part takes
// some seconds to some tens of seconds, on the calling thread. Errors: `cancelled` once
// Options::stop returns true, and those that each part states. Thread safety: functions without
// state; two charts at once disturb each other's times.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "chart/table.h"
#include "fit/data/data.h"
#include "gonio/base/result.h"
#include "gonio/measured/table.h"
#include "timing/race.h"

namespace gonio::chart {

struct Options {
  timing::Effort effort;
  std::size_t pairs = 5000;  // at each place of assess/places.h, for errors
  std::uint64_t seed = 1;
  std::function<bool()> stop;  // asked often; true ends the chart
  std::function<void(double)>
      progress;  // the share that is done, 0 to 1; called by the calling thread
};

// (a) A material of each model on each instruction set in both precisions, and as a scalar loop as
// printed, in float32 and float64: ns an evaluation of three channels in batches of 4096, against
// relative errors to the model's formula in long double over the places of assess/places.h. Fronts
// are by model.
Result<Table> chart_models(const Options& options);

// Measurements of a material.
struct Measured {
  std::string name;
  fit::Data data;
  std::shared_ptr<const MeasuredTable> table;  // null: scattered pairs
};

// (b) The models fitted to the measurements by L1, and the table itself in both interpolations: ns
// and bytes against all metrics of fit/report/metrics.h. Fits that fail are left out.
Result<Table> chart_fits(const Measured& measured, const Options& options);

// (c) Fresnel's term in one lobe as a constant, by Schlick and exact, for substances; Schlick's
// error by angle; and formulas that publications print wrongly, beside the right ones. Fronts are
// by substance and by formula.
Result<Table> chart_fresnel(const Options& options);
Table chart_fresnel_angles();
Result<Table> chart_printed(const Options& options);

// (e) Samples of a material of each model by gonio's strategy, by the cosine and by a textbook's
// strategy: ns per sample against the variance of the weights, for light at 30 and at 75 degrees,
// and from both the time to a standard error of 1 %.
Result<Table> chart_sampling(const Options& options);

// (d) The accuracy of the types on the wire, float32 or float64 directions and values: bytes a pair
// against the error to f at the directions before rounding. The command line measures their speed
// through the client (client/cli/chart/wire.h).
Result<Table> chart_directions(const Options& options);

// (f) A measured table (`measured.table` must not be null) in fewer cells, read from the nearest
// cell and linearly: bytes against its errors at the centres of the full table's cells.
Result<Table> chart_resolution(const Measured& measured, const Options& options);

}  // namespace gonio::chart
