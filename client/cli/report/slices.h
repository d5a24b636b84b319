// Slices of measurements and of materials for `gonio compare`. Thread safety: no state.
#pragma once

#include <vector>

#include "client/picture/lobe/slices.h"
#include "fit/data/data.h"
#include "gonio/base/result.h"
#include "gonio/engine/material.h"

namespace gonio::cli {

struct Slices {
  std::vector<lobe::SlicePanel> panels;  // a row for each channel that is shown
  std::size_t columns = 0;               // angles of incidence
};

// The measurements in the plane of incidence at 30, 60 and 80 degrees, each or the measured angle
// that is nearest to it within 5 degrees, and what the materials reflect there. All channels up to
// three, of more of them three. The materials have one channel, or those of the data. Errors: data
// that have nothing there.
Result<Slices> slices_of(const fit::Data& data, const std::vector<Material>& materials);

}  // namespace gonio::cli
