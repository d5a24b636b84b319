// The reference of a selection, as three sets of pairs that have nothing in common: candidates are
// fitted to the first, compared by the second, and the choice is certified by the third.
#pragma once

#include <functional>

#include "fit/data/data.h"
#include "select/error/distribution.h"

namespace gonio::select {

// Asked often; once it says so the sets are `cancelled`.
using Stop = std::function<bool()>;

struct SetSizes {
  std::size_t fitted = 4000, validation = 8192, certification = 16384;
  [[nodiscard]] std::size_t total() const { return fitted + validation + certification; }
};

struct Sets {
  fit::Data fitted, validation, certification;
};

// Measured pairs, each weighed by what it stands for times the scene's density there, put into an
// order by `seed` that means nothing. Of fewer pairs than `sizes` asks for a third is fitted to, if
// that is not more than asked for, and the other sets share the rest. Pairs whose wi all lie in one
// plane with the normal say nothing of the surface turned: each is turned at random, so that no
// anisotropy is fitted to them. Errors: "reference", with what was left out, where fewer than 200
// are in the scene; cancelled.
Result<Sets> sets_of(const fit::Data& data, const Distribution& scene, const SetSizes& sizes,
                     std::uint64_t seed, const Stop& stop = {});

// Pairs drawn for a material: wi by the scene, wo for one half by the scene and for the other by
// the material's own sampler, so that no lobe is missed; weights are the density of the scene over
// that of both together, and 0 in the holes of a measured table. Error: "reference" where it
// reflects nothing that is finite.
Result<Sets> sets_of(const Material& reference, const Distribution& scene, const SetSizes& sizes,
                     std::uint64_t seed, const Stop& stop = {});

// The draws of the above by themselves.
fit::Data draw_pairs(const Material& reference, const Distribution& scene, std::size_t count,
                     std::uint64_t seed, const Stop& stop = {});

}  // namespace gonio::select
