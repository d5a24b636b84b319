// The machine and the build that a chart was measured with. Thread safety: a function without
// state.
#pragma once

#include "gonio/chart/table.h"

namespace gonio::chart {

Machine this_machine();

}  // namespace gonio::chart
