// What a Sampler holds, for the engine only.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/material/material_impl.h"
#include "gonio/engine/sampler.h"
#include "kernels/choose.h"

namespace gonio {

struct Sampler::Impl {
  int lobes = 0;          // the parts of the material that draw for themselves, in their order
  bool cosine = false;    // whether the cosine is a strategy, too
  bool has_gaps = false;  // whether the material may be unknown in places
  MixtureTable table{};
  std::vector<PartData> drawn;  // of each part what its draws and densities read; null: it has none

  [[nodiscard]] int strategies() const { return lobes + (cosine ? 1 : 0); }
};

}  // namespace gonio
