// The batch kernels of one instruction set: compiled three times, with GONIO_ISA naming the
// namespace.
//
// One function per kind of model and precision; see analytic_kernel.h.
#include <array>
#include <type_traits>

#include "engine/kernels/analytic_kernel.h"
#include "engine/kernels/kernel.h"
#include "engine/kernels/measured_kernel.h"
#include "models/all.h"
#include "numeric/derivative.h"

namespace gonio::GONIO_ISA {
namespace {

struct NothingBeside {
  GONIO_INLINE void stage(std::size_t, const auto&, const auto&) {}
  GONIO_INLINE void finish(std::size_t, const auto&, const auto&, std::size_t) {}
};

template <class N, class Kind, class In>
void analytic(const void* constants, const KernelInput<In>& in,
              const KernelOutput<typename N::Out>& out) {
  NothingBeside nothing;
  analytic_with<N, Kind>(constants, in, out, nothing);
}

template <class Kind>
constexpr KernelSet kernel_set() {
  return {&analytic<Fast, Kind, float>, &analytic<Reference, Kind, float>,
          &analytic<Reference, Kind, double>};
}

template <class Kind>
constexpr DerivativeKernels derivative_kernels() {
  return {&analytic<Derivative, Kind, float>, &analytic<Derivative, Kind, double>};
}

template <class... Kinds>
constexpr std::array<KernelSet, sizeof...(Kinds)> kernel_sets(TypeList<Kinds...>) {
  return {kernel_set<Kinds>()...};
}

template <class... Kinds>
constexpr std::array<DerivativeKernels, sizeof...(Kinds)> all_derivatives(TypeList<Kinds...>) {
  return {derivative_kernels<Kinds>()...};
}

constexpr auto kDerivatives = all_derivatives(AllKinds{});
constexpr auto kAnalytic = kernel_sets(AllKinds{});

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

}  // namespace

extern const KernelTable kKernels;  // NOLINT(readability-redundant-declaration): linkage
const KernelTable kKernels{
    .width = raw::kWidth,
    .analytic = kAnalytic.data(),
    .derivatives = kDerivatives.data(),
    .measured_linear = {&measured<Fast, true, float>, &measured<Reference, true, float>,
                        &measured<Reference, true, double>},
    .measured_nearest = {&measured<Fast, false, float>, &measured<Reference, false, float>,
                         &measured<Reference, false, double>},
    .layout32 = {&split<float>, &join_channels<float>},
    .layout64 = {&split<double>, &join_channels<double>},
};

}  // namespace gonio::GONIO_ISA
