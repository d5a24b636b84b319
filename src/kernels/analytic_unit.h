// The kernels of one analytic model in one instruction set: what kernels/unit.cpp.in makes a file
// of.
#pragma once

#include "kernels/analytic_kernel.h"
#include "kernels/draw_kernel.h"
#include "kernels/sampling_kernel.h"
#include "numeric/derivative.h"
#include "numeric/type_list.h"

namespace gonio::GONIO_ISA {
namespace {  // with weak symbols, lambertian on the baseline was 11 % slower

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

// The densities of a lobe, beside its values.
template <class N, class Kind>
struct DensityBeside {
  DensityOutput<typename N::Out> out;
  typename Kind::template Aim<N> aim[kBlock];

  explicit GONIO_INLINE DensityBeside(const DensityOutput<typename N::Out>& to) : out(to) {}

  GONIO_INLINE void stage(std::size_t p, const auto& shape, const Geometry<N>& g) {
    aim[p] = Kind::template aim<N>(shape, g);
  }
  GONIO_INLINE void finish(std::size_t p, const auto& shape, const Block<N, Kind>& block,
                           std::size_t begin) {
    using Real = typename N::Real;
    const std::size_t at = begin + p * raw::kWidth;
    const Real found = Kind::template pdf<N>(shape, block.stage[p], block.refined[p], aim[p]);
    Real density = select(block.valid[p], min(N::largest(), found), Real(0));
    if (out.share != nullptr) density = density * Real::load(out.share + at);
    if (out.accumulate) density = density + Real::load(out.pdf + at);
    density.store(out.pdf + at);
  }
};

template <class N, class Kind, class In>
void with_density(const void* constants, const KernelInput<In>& in,
                  const KernelOutput<typename N::Out>& out,
                  const DensityOutput<typename N::Out>& density) {
  DensityBeside<N, Kind> beside(density);
  analytic_with<N, Kind>(constants, in, out, beside);
}

template <class Kind, class T>
void draw(const void* constants, const DrawRun<T>& run) {
  const auto& given = *static_cast<const Constants<Kind>*>(constants);
  const auto shape = given.shape;
  const auto draw_one = [&](const auto& wi, const auto& xi) {
    return Kind::Drawn::template sample<DrawNumbers<T>>(shape, wi, xi);
  };
  if constexpr (has_tangents<Kind>()) {
    if (given.tangents.turned) {
      const auto turn = given.tangents.rotation;
      // In what the draw is computed in: it rounds as much.
      draw_with(run, [&](const auto& wi, const auto& xi) {
        return out_of(turn, draw_one(into(turn, wi), xi));
      });
      return;
    }
  }
  draw_with(run, draw_one);
}

template <class Kind>
constexpr SamplingKernels sampling_kernels_of() {
  if constexpr (requires { typename Kind::Drawn; }) {
    return {&with_density<Fast, Kind, float>, &with_density<Reference, Kind, float>,
            &with_density<Reference, Kind, double>, &draw<Kind, float>, &draw<Kind, double>};
  } else {
    return {};
  }
}

template <class... Kinds>
constexpr KernelArray<sizeof...(Kinds)> kernels_of(TypeList<Kinds...>) {
  return {{PartKernels{{&analytic<Fast, Kinds, float>, &analytic<Reference, Kinds, float>,
                        &analytic<Reference, Kinds, double>},
                       sampling_kernels_of<Kinds>()}...}};
}

// The same, of the derivative by the parameter that the constants were prepared for.
template <class... Kinds>
constexpr KernelArray<sizeof...(Kinds)> derivatives_of(TypeList<Kinds...>) {
  return {{PartKernels{
      {nullptr, &analytic<Derivative, Kinds, float>, &analytic<Derivative, Kinds, double>},
      {}}...}};
}

}  // namespace
}  // namespace gonio::GONIO_ISA
