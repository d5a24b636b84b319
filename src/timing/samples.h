// What samplers are timed on: directions of incidence over the hemisphere, random numbers, and room
// for samples. Thread safety: one thread at a time runs what shares a Samples.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "gonio/engine/sampler.h"
#include "timing/race.h"

namespace gonio::timing {

// One sample of each direction, interleaved as they come over the wire; three channels.
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
