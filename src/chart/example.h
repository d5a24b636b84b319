// An example of a measured material for when none is given: a glossy paint. Thread safety: a
// function without state.
#pragma once

#include <cstdint>
#include <memory>

#include "gonio/measured/table.h"

namespace gonio::chart {

// An Oren-Nayar base under a sharp and a wide GGX lobe, which no single lobe fits, in MERL's
// layout, with 2 % noise per cell.
std::shared_ptr<const MeasuredTable> example_table(std::uint64_t seed);

}  // namespace gonio::chart
