// A measured material where none is given: what a goniometer might have found of a glossy paint.
// Thread safety: a function without state.
#pragma once

#include <cstdint>
#include <memory>

#include "gonio/measured/table.h"

namespace gonio::chart {

// An Oren-Nayar base under a sharp and a wide GGX lobe, which no single lobe is like, in MERL's
// layout, with noise of 2 % a cell.
std::shared_ptr<const MeasuredTable> example_table(std::uint64_t seed);

}  // namespace gonio::chart
