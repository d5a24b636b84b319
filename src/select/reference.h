// The reference of a selection as three disjoint sets of pairs. Candidates are fitted to the first
// and compared on the second; the choice is certified on the third.
#pragma once

#include <functional>

#include "fit/data/data.h"
#include "select/error/distribution.h"

namespace gonio::select {

// Called often; after it returns true the result is `cancelled`.
using Stop = std::function<bool()>;

struct SetSizes {
  std::size_t fitted = 4000, validation = 8192, certification = 16384;
  [[nodiscard]] std::size_t total() const { return fitted + validation + certification; }
};

struct Sets {
  fit::Data fitted, validation, certification;
};

// Measured pairs, each weighted by what it stands for times the scene's density there, in a random
// order that `seed` determines. If there are fewer pairs than `sizes` asks for, the first set gets
// a third of them, at most its size, and the other sets share the rest. Pairs whose wi all lie in
// one plane with the normal do not show how the surface reflects when it is turned. Each of them is
// turned by a random angle, so that no anisotropy is fitted to them. Errors: "reference", with what
// was left out, where fewer than 200 are in the scene; cancelled.
Result<Sets> sets_of(const fit::Data& data, const Distribution& scene, const SetSizes& sizes,
                     std::uint64_t seed, const Stop& stop = {});

// Pairs drawn for a material: wi from the scene, wo for one half from the scene and for the other
// from the material's own sampler, so that no lobe is missed. Weights are the density of the scene
// over that of both together, and 0 in the holes of a measured table. Error: "reference" where it
// reflects nothing that is finite.
Result<Sets> sets_of(const Material& reference, const Distribution& scene, const SetSizes& sizes,
                     std::uint64_t seed, const Stop& stop = {});

// The draws alone, before they become sets.
fit::Data draw_pairs(const Material& reference, const Distribution& scene, std::size_t count,
                     std::uint64_t seed, const Stop& stop = {});

}  // namespace gonio::select
