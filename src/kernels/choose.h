// Which of a table's functions works on directions of type In and gives values of type Out.
#pragma once

#include "kernels/sampling_kernel.h"

namespace gonio {

inline Kernel<float, float> kernel_of(const EvalKernels& k, float, float) { return k.fast; }
inline Kernel<float, double> kernel_of(const EvalKernels& k, float, double) { return k.reference; }
inline Kernel<double, double> kernel_of(const EvalKernels& k, double, double) {
  return k.reference64;
}
inline DensityKernel<float, float> density_of(const SamplingKernels& k, float, float) {
  return k.fast;
}
inline DensityKernel<float, double> density_of(const SamplingKernels& k, float, double) {
  return k.reference;
}
inline DensityKernel<double, double> density_of(const SamplingKernels& k, double, double) {
  return k.reference64;
}
inline Draw<float> draw_of(const SamplingKernels& k, float) { return k.draw32; }
inline Draw<double> draw_of(const SamplingKernels& k, double) { return k.draw64; }

inline Draw<float> cosine_of(const SamplingTable& t, float) { return t.cosine32; }
inline Draw<double> cosine_of(const SamplingTable& t, double) { return t.cosine64; }
inline Share<float> share_of(const SamplingTable& t, float) { return t.share32; }
inline Share<double> share_of(const SamplingTable& t, double) { return t.share64; }
inline SplitNumbers<float> split_of(const SamplingTable& t, float) { return t.split32; }
inline SplitNumbers<double> split_of(const SamplingTable& t, double) { return t.split64; }
inline Finish<float, float> finish_of(const SamplingTable& t, float, float) { return t.fast; }
inline Finish<float, double> finish_of(const SamplingTable& t, float, double) {
  return t.reference;
}
inline Finish<double, double> finish_of(const SamplingTable& t, double, double) {
  return t.reference64;
}

}  // namespace gonio
