// What `gonio compare` says: a table for people, and the same as JSON. Thread safety: no state.
#pragma once

#include <string>
#include <vector>

#include "client/cli/compare/comparison.h"
#include "fit/report/metrics.h"

namespace gonio::cli {

// How far each of the compared materials is from the measurements, in their order.
std::vector<fit::Comparison> errors_of(const Comparison& comparison);

std::string compare_table(const Comparison& comparison, const std::vector<fit::Comparison>& found);

// {"reference": FILE, "pairs": N, "left_out": N, "materials": [{"name": ..., "errors": {"all":
// {"pairs": N, "l1": ..., "rmse": ..., "log": ..., "cbrt": ...}, "below_80": ..., "above_80": ...},
// "regions": {"mirror": {"measured": ..., "fitted": ..., "error": ...}, ...}}, ...]}. The errors of
// a zone without pairs are null.
std::string compare_json(const std::string& reference, const Comparison& comparison,
                         const std::vector<fit::Comparison>& found);

}  // namespace gonio::cli
