// Measures the parts of a chart. Thread safety: a function without state.
#pragma once

#include "client/cli/chart/arguments.h"
#include "client/cli/chart/tables.h"
#include "gonio/base/result.h"

namespace gonio::cli {

// The parts that are wanted, one after the other. Errors name the file of --data.
Result<Chart> measure(const ChartArguments& arguments);

}  // namespace gonio::cli
