// The error of a material over pairs, block by block.
#pragma once

#include <vector>

#include "fit/data/data.h"
#include "gonio/engine/material.h"
#include "gonio/select/selection.h"
#include "select/error/interval.h"
#include "select/scene.h"

namespace gonio::select {

// Checks that the metric is defined for so many channels. The error names "scene.metric".
Outcome check(Metric metric, int channels);

// Pairs in random order, cut into blocks of about the same size: at most 64, of 16 pairs or more
// where there are enough.
struct Blocks {
  explicit Blocks(const fit::Data& data);
  std::vector<fit::Data> parts;
};

// The metric as a ratio of sums over `data`: for rmse and cbrt its square.
Ratio error_of(const Material& material, const fit::Data& data, Metric metric);
// The same of each block.
std::vector<Ratio> errors_of(const Material& material, const Blocks& blocks, Metric metric);
// The metric from the value of such a ratio.
double root_if_square(double ratio, Metric metric);

inline constexpr double kWorthTrying = 0.95;  // of bounds on the second set
// Each bound holds with `confidence`.
Bounded bounded(const std::vector<Ratio>& errors, Metric metric, double confidence);

// The difference of a material's float32 and float64 evaluations, by the metric (relative to the
// measured values).
double float32_error(const Material& material, const Blocks& blocks, Metric metric);

}  // namespace gonio::select
