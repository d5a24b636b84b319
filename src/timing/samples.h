// Input and output of timed samplers: directions of incidence over the hemisphere, random numbers,
// and memory for samples. Thread safety: runners that share a Samples run on one thread at a time.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "gonio/engine/sampler.h"
#include "timing/race.h"

namespace gonio::timing {

// One sample per direction, interleaved as on the wire; three channels.
struct Samples {
  explicit Samples(std::size_t count);

  // `given`: the numbers are xi; otherwise they are generated.
  [[nodiscard]] SampleBatch<float> batch(bool given);

  std::size_t count;
  std::vector<float> wi, xi, wo, weights, pdf;
};

// Draws all samples with their densities and weights once a run, on one thread; an item is a
// sample.
Runner sampling(const std::shared_ptr<Samples>& samples, const Sampler& sampler, Isa isa,
                bool given);

}  // namespace gonio::timing
