// The pictures of `gonio compare`. Thread safety: used by one thread.
#pragma once

#include <string>
#include <vector>

#include "client/cli/compare/comparison.h"
#include "gonio/base/result.h"
#include "gonio/client/client.h"

namespace gonio::cli {

// A PNG of slices: measured dots, a line for each material.
Result<std::string> slices_png(const std::string& title, const fit::Data& data,
                               const std::vector<Compared>& compared);

// A PNG of spheres, the measured one first: in a directional light above, in the light of a sky
// below. `measured` is one that can be evaluated.
Result<std::string> spheres_png(const std::string& title, const client::Client& client,
                                const client::Material& measured,
                                const std::vector<Compared>& compared);

}  // namespace gonio::cli
