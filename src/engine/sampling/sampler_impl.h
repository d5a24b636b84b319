// What a Sampler holds, for the engine only.
#pragma once

#include <cstddef>
#include <memory>

#include "engine/kernels/sampling_kernel.h"
#include "engine/material/material_impl.h"
#include "gonio/engine/sampler.h"
#include "measured/table_sampling.h"

namespace gonio {

struct Sampler::Impl {
  int lobes = 0;        // the parts of the material that draw for themselves, in their order
  bool cosine = false;  // whether the cosine is a strategy, too
  MixtureTable table{};
  std::unique_ptr<const TableSampling> measured;  // of a measured material, its only part

  [[nodiscard]] int strategies() const { return lobes + (cosine ? 1 : 0); }
};

inline Draw<float> draw_of(const SamplingKernels& k, float) { return k.draw32; }
inline Draw<double> draw_of(const SamplingKernels& k, double) { return k.draw64; }
inline Draw<float> cosine_of(const SamplingTable& t, float) { return t.cosine32; }
inline Draw<double> cosine_of(const SamplingTable& t, double) { return t.cosine64; }
inline Share<float> share_of(const SamplingTable& t, float) { return t.share32; }
inline Share<double> share_of(const SamplingTable& t, double) { return t.share64; }
inline SplitNumbers<float> split_of(const SamplingTable& t, float) { return t.split32; }
inline SplitNumbers<double> split_of(const SamplingTable& t, double) { return t.split64; }
inline DensityKernel<float, float> density_of(const SamplingKernels& k, float, float) {
  return k.fast;
}
inline DensityKernel<float, double> density_of(const SamplingKernels& k, float, double) {
  return k.reference;
}
inline DensityKernel<double, double> density_of(const SamplingKernels& k, double, double) {
  return k.reference64;
}
inline Finish<float, float> finish_of(const SamplingTable& t, float, float) { return t.fast; }
inline Finish<float, double> finish_of(const SamplingTable& t, float, double) {
  return t.reference;
}
inline Finish<double, double> finish_of(const SamplingTable& t, double, double) {
  return t.reference64;
}
inline Kernel<float, float> kernel_of(const KernelSet& set, float, float) { return set.fast; }
inline Kernel<float, double> kernel_of(const KernelSet& set, float, double) {
  return set.reference;
}
inline Kernel<double, double> kernel_of(const KernelSet& set, double, double) {
  return set.reference64;
}

}  // namespace gonio
