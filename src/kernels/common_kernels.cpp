// What one instruction set offers whatever is evaluated: compiled three times, with GONIO_ISA
// naming the namespace.
#include "kernels/draw_kernel.h"
#include "kernels/kernel.h"
#include "kernels/mixture_kernel.h"
#include "kernels/number_kernel.h"
#include "kernels/sampling_kernel.h"

namespace gonio::GONIO_ISA {
namespace {

template <class T>
void split(const T* __restrict xyz, std::size_t n, T* __restrict x, T* __restrict y,
           T* __restrict z) {
  std::size_t i = 0;
  if constexpr (std::is_same_v<T, float>) {
    for (; i + raw::kWidth <= n; i += raw::kWidth) {
      raw::F px, py, pz;
      fetch_ahead(xyz + 3 * i);
      raw::split3(xyz + 3 * i, px, py, pz);
      raw::store(x + i, px), raw::store(y + i, py), raw::store(z + i, pz);
    }
  }
  for (; i < n; ++i) {
    x[i] = xyz[3 * i];
    y[i] = xyz[3 * i + 1];
    z[i] = xyz[3 * i + 2];
  }
}

template <class T>
void join_three(const T* __restrict x, const T* __restrict y, const T* __restrict z, std::size_t n,
                T* __restrict xyz) {
  std::size_t i = 0;
  if constexpr (std::is_same_v<T, float>) {
    for (; i + raw::kWidth <= n; i += raw::kWidth) {
      fetch_ahead(xyz + 3 * i);
      raw::join3(raw::load(x + i), raw::load(y + i), raw::load(z + i), xyz + 3 * i);
    }
  }
  for (; i < n; ++i) {
    xyz[3 * i] = x[i];
    xyz[3 * i + 1] = y[i];
    xyz[3 * i + 2] = z[i];
  }
}

template <class T>
void join_channels(const T* __restrict planar, std::size_t channel_stride, int channels,
                   std::size_t n, T* __restrict out) {
  if (channels == 3) {
    join_three(planar, planar + channel_stride, planar + 2 * channel_stride, n, out);
    return;
  }
  const auto count = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t c = 0; c < count; ++c) out[i * count + c] = planar[c * channel_stride + i];
  }
}

// By cos(theta_o) / pi.
template <class T>
void draw_cosine(const void*, const DrawRun<T>& run) {
  using Real = typename DrawNumbers<T>::Real;
  draw_with(run, [](const auto&, const Xi<Real>& xi) {
    const auto phi = turn(xi.u);
    const Real radius = sqrt(xi.v);
    return Vec3<Real>{radius * phi.cos, radius * phi.sin, sqrt(Real(1) - xi.v)};
  });
}

}  // namespace

extern const KernelTable kKernels;  // NOLINT(readability-redundant-declaration): linkage
const KernelTable kKernels{
    .width = raw::kWidth,
    .layout32 = {&split<float>, &join_channels<float>},
    .layout64 = {&split<double>, &join_channels<double>},
};

extern const SamplingTable kSampling;  // NOLINT(readability-redundant-declaration): linkage
const SamplingTable kSampling{
    .cosine32 = &draw_cosine<float>,
    .cosine64 = &draw_cosine<double>,
    .share32 = &share<float>,
    .share64 = &share<double>,
    .numbers32 = &random_numbers<float>,
    .numbers64 = &random_numbers<double>,
    .split32 = &split_numbers<float>,
    .split64 = &split_numbers<double>,
    .fast = &finish<Fast, float>,
    .reference = &finish<Reference, float>,
    .reference64 = &finish<Reference, double>,
};

}  // namespace gonio::GONIO_ISA
