// Draws directions for a material, and says with what density.
//
// A sample has a direction wo, its pdf per solid angle, and a weight f cos(theta_o) / pdf in every
// channel. Each specular lobe of an analytic material is drawn by a strategy of its own (see its
// file in models/), all that is diffuse by the cosine; a sum is drawn by the mixture of these whose
// shares, tabulated over the angle of incidence when the sampler is made, give the weights the
// least variance. The pdf is that of the whole mixture, so that it holds whichever strategy drew.
//
// Values and pdfs are those of the returned direction as rounded: evaluating (wi, wo) again gives
// the same f, with the sampler or without it, and the same pdf, bit for bit.
//
// A direction at or below the horizon is a lost sample: it has pdf 0, weight 0 and the flag
// outgoing_below_horizon, and counts as a sample with the value 0. Only lobes of ggx lose any; a
// mean over all samples, lost ones included, is right. So is a sample of a measured material where
// the table knows nothing; its flag is outside_data.
//
// Thread safety: a Sampler is immutable and cheap to copy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "gonio/engine/evaluate.h"
#include "gonio/engine/material.h"
#include "gonio/engine/random_numbers.h"

namespace gonio {

class Sampler {
 public:
  static Sampler create(const Material& material);

  [[nodiscard]] const Material& material() const { return material_; }
  [[nodiscard]] std::size_t bytes() const;  // memory held beside the material's

  // For the engine.
  struct Impl;
  [[nodiscard]] const Impl& impl() const { return *impl_; }

 private:
  Sampler(Material material, std::shared_ptr<const Impl> impl)
      : material_(std::move(material)), impl_(std::move(impl)) {}
  Material material_;
  std::shared_ptr<const Impl> impl_;
};

// T: float is Precision::fast, double is Precision::reference.
//
// Samples are numbered through a whole request: sample g belongs to wi number g / per_wi. A batch
// is a run of them, so that any slice can be asked for again and be the same.
template <class T>
struct SampleBatch {
  Directions<T> wi;          // beginning with the one that sample `first` belongs to
  std::uint64_t first = 0;   // the number of the batch's first sample
  std::size_t count = 0;     // samples
  std::uint64_t per_wi = 1;  // samples of each wi
  // Three numbers in [0, 1) a sample, interleaved: which strategy, and two for the direction. If
  // null, they are generated.
  const T* xi = nullptr;
  NumberSource numbers;
  T* wo = nullptr;                // interleaved xyz
  T* pdf = nullptr;               // per steradian
  Values<T> weights;              // f cos(theta_o) / pdf, material.channels() a sample; or no data
  std::uint8_t* flags = nullptr;  // one byte a sample, or null
};

// What became of a batch: all flags or'ed, and how many samples were lost below the horizon.
struct SampleReport {
  std::uint8_t any_flags = 0;
  std::uint64_t lost = 0;
};

// Draws the whole batch on the calling thread. A sample whose wi or xi is bad has wo (0,0,0), pdf
// and weights 0 and a flag. `isa` must be supported.
SampleReport sample(const Sampler& sampler, const SampleBatch<float>& batch, Isa isa);
SampleReport sample(const Sampler& sampler, const SampleBatch<double>& batch, Isa isa);

// As evaluate() without a sampler, and the density with which wo is drawn for wi; `pdf` has room
// for one number a pair.
std::uint8_t evaluate(const Sampler& sampler, const Batch<float, float>& batch, float* pdf,
                      Isa isa);
std::uint8_t evaluate(const Sampler& sampler, const Batch<float, double>& batch, double* pdf,
                      Isa isa);
std::uint8_t evaluate(const Sampler& sampler, const Batch<double, double>& batch, double* pdf,
                      Isa isa);

}  // namespace gonio
