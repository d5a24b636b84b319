// The pictures of `gonio compare`. Thread safety: used by one thread.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "client/client.h"
#include "engine/material.h"
#include "fit/data.h"

namespace gonio::cli {

// What is compared, by its name in the pictures.
struct Compared {
  std::string name;
  client::Material asked;  // as the service takes it
  Material material;       // the same, built
};

// A PNG of slices: measured dots, a line for each material.
Result<std::string> slices_png(const std::string& title, const fit::Data& data,
                               const std::vector<Compared>& compared);

// A PNG of spheres, the measured one first: in a directional light above, in the light of a sky
// below. `measured` is one that can be evaluated.
Result<std::string> spheres_png(const std::string& title, const client::Client& client,
                                const client::Material& measured,
                                const std::vector<Compared>& compared);

}  // namespace gonio::cli
