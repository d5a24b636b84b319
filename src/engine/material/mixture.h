// The shares of a mixture's strategies.
#pragma once

#include "engine/material/material_impl.h"
#include "engine/sampling/sampler_impl.h"

namespace gonio {

// Fills `sampler.table` and decides whether the cosine is worth its cost.
void tabulate_shares(const Material::Impl& material, Sampler::Impl& sampler);

}  // namespace gonio
