// What a chart was measured on, and with. Thread safety: a function without state.
#pragma once

#include "gonio/chart/table.h"

namespace gonio::chart {

Machine this_machine();

}  // namespace gonio::chart
