// The batch kernels of one instruction set: compiled three times, with GONIO_ISA naming the namespace.
//
// One function per kind of model and precision loops over packets: geometry once, then every channel. There is no
// remainder loop: callers pad, so that a pair's result cannot depend on where in a batch it stands.
#include <array>

#include "engine/constants.h"
#include "engine/evaluate.h"
#include "engine/kernel.h"
#include "engine/measured_kernel.h"
#include "engine/packet_io.h"
#include "models/all.h"
#include "numeric/number.h"
#include "parts/geometry.h"

namespace gonio::GONIO_ISA {
namespace {

template <class N, class Kind, class In>
void analytic(const void* constants, const KernelInput<In>& input, const KernelOutput<typename N::Out>& output) {
  using Real = typename N::Real;
  using RealScalar = typename N::RealScalar;
  const auto& given = *static_cast<const Constants<Kind>*>(constants);
  // Copies that no store can alias, so that they stay in registers.
  const KernelInput<In> in = input;
  const KernelOutput<typename N::Out> out = output;
  const auto shape = given.shape;
  const int channels = given.channels;
  for (std::size_t i = 0; i < in.count; i += raw::kWidth) {
    const Geometry<N> g = load_geometry<N>(in, i);
    const unsigned valid = g.valid.bits();
    if (valid != kAllLanes) note_flags(in, i, valid, out.flags);
    const auto terms = Kind::template terms<N>(shape, g);
    for (int c = 0; c < channels; ++c) {
      const Real value = Kind::template value<N>(terms, given.wide[c], given.template channel<RealScalar>(c));
      typename N::Out* to = out.values + static_cast<std::size_t>(c) * out.channel_stride + i;
      Real result = select(g.valid, min(N::largest(), value), Real(0));
      if (out.accumulate) result = min(N::largest(), result + Real::load(to));
      result.store(to);
    }
  }
}

template <class Kind>
constexpr KernelSet kernel_set() {
  return {&analytic<Fast, Kind, float>, &analytic<Reference, Kind, float>, &analytic<Reference, Kind, double>};
}

// The sets of all kinds of all models, in the registry's order.
template <class... Kinds, class... More>
auto concatenate(TypeList<Kinds...>, TypeList<More...>) -> TypeList<Kinds..., More...>;

template <class Done, class Models>
struct AllKinds;
template <class Done>
struct AllKinds<Done, TypeList<>> {
  using Type = Done;
};
template <class Done, class Model, class... Models>
struct AllKinds<Done, TypeList<Model, Models...>> {
  using Joined = decltype(concatenate(Done{}, typename Model::Kinds{}));
  using Type = typename AllKinds<Joined, TypeList<Models...>>::Type;
};

template <class... Kinds>
constexpr std::array<KernelSet, sizeof...(Kinds)> kernel_sets(TypeList<Kinds...>) {
  return {kernel_set<Kinds>()...};
}

constexpr auto kAnalytic = kernel_sets(AllKinds<TypeList<>, AllModels>::Type{});

template <class T>
void split(const T* __restrict xyz, std::size_t n, T* __restrict x, T* __restrict y, T* __restrict z) {
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = xyz[3 * i];
    y[i] = xyz[3 * i + 1];
    z[i] = xyz[3 * i + 2];
  }
}

template <class T>
void join_channels(const T* __restrict planar, std::size_t channel_stride, int channels, std::size_t n, T* __restrict out) {
  if (channels == 3) {
    for (std::size_t i = 0; i < n; ++i) {
      out[3 * i] = planar[i];
      out[3 * i + 1] = planar[channel_stride + i];
      out[3 * i + 2] = planar[2 * channel_stride + i];
    }
    return;
  }
  const auto count = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t c = 0; c < count; ++c) out[i * count + c] = planar[c * channel_stride + i];
  }
}

}  // namespace

extern const KernelTable kKernels;
const KernelTable kKernels{
    .width = raw::kWidth,
    .analytic = kAnalytic.data(),
    .measured_linear = {&measured<Fast, true, float>, &measured<Reference, true, float>, &measured<Reference, true, double>},
    .measured_nearest = {&measured<Fast, false, float>, &measured<Reference, false, float>, &measured<Reference, false, double>},
    .layout32 = {&split<float>, &join_channels<float>},
    .layout64 = {&split<double>, &join_channels<double>},
};

}  // namespace gonio::GONIO_ISA
