#include "timing/samples.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace gonio::timing {

Samples::Samples(std::size_t n)
    : count(n), wi(3 * n), xi(3 * n), wo(3 * n), weights(3 * n), pdf(n) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform;
  for (std::size_t i = 0; i < n; ++i) {
    const float z = uniform(random) * 0.999F + 0.001F, phi = 6.2831853F * uniform(random),
                s = std::sqrt(1 - z * z);
    wi[3 * i] = s * std::cos(phi), wi[3 * i + 1] = s * std::sin(phi), wi[3 * i + 2] = z;
    for (std::size_t c = 0; c < 3; ++c) xi[3 * i + c] = std::min(uniform(random), 0.9999999F);
  }
}

SampleBatch<float> Samples::batch(bool given) {
  SampleBatch<float> batch;
  batch.wi = Directions<float>::interleaved(wi.data());
  batch.count = count;
  if (given) batch.xi = xi.data();
  batch.wo = wo.data();
  batch.pdf = pdf.data();
  batch.weights = Values<float>::interleaved(weights.data(), 3);
  return batch;
}

Runner sampling(const std::shared_ptr<Samples>& samples, const Sampler& sampler, Isa isa,
                bool given) {
  return {[samples, sampler, isa, given] { (void)sample(sampler, samples->batch(given), isa); },
          static_cast<double>(samples->count)};
}

}  // namespace gonio::timing
