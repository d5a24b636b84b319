// The sampling kernels of one instruction set, compiled like kernels.cpp.
#include <array>
#include <type_traits>

#include "engine/kernels/analytic_kernel.h"
#include "engine/kernels/mixture_kernel.h"
#include "engine/kernels/number_kernel.h"
#include "engine/kernels/sampling_kernel.h"
#include "models/all.h"
#include "numeric/twofold.h"

namespace gonio::GONIO_ISA {
namespace {

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
    const Real found = Kind::template density<N>(shape, block.stage[p], block.refined[p], aim[p]);
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

// The number system that draws to be stored as T are computed in.
template <class T>
using DrawNumbers = std::conditional_t<std::is_same_v<T, float>, TwofoldFast, Reference>;

template <class T, class DrawOne>
GONIO_INLINE void draw_with(const DrawRun<T>& given, const DrawOne& draw_one) {
  const auto run = given;  // a copy that no store can alias
  using N = DrawNumbers<T>;
  using Real = typename N::Real;
  const Real low(run.strategy - 0.5), high(run.strategy + 0.5);
  for (std::size_t i = 0; i < run.count; i += sizeof(Real) / sizeof(T)) {
    const Xi<Real> xi{Real::load(run.xi[0] + i), Real::load(run.xi[1] + i),
                      Real::load(run.xi[2] + i)};
    Vec3<Real> wo = draw_one(load_unit<N>(run.wi, i), xi);
    if (run.chosen != nullptr) {
      const Real chosen = Real::load(run.chosen + i);
      const auto mine = (low < chosen) & (chosen < high);
      wo.x = select(mine, wo.x, Real::load(run.wo[0] + i));
      wo.y = select(mine, wo.y, Real::load(run.wo[1] + i));
      wo.z = select(mine, wo.z, Real::load(run.wo[2] + i));
    }
    wo.x.store(run.wo[0] + i), wo.y.store(run.wo[1] + i), wo.z.store(run.wo[2] + i);
  }
}

template <class Kind, class T>
void draw(const void* constants, const DrawRun<T>& run) {
  const auto& given = *static_cast<const Constants<Kind>*>(constants);
  const auto shape = given.shape;
  const auto draw_one = [&](const auto& wi, const auto& xi) {
    return Kind::Drawn::template draw<DrawNumbers<T>>(shape, wi, xi);
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

template <class Kind>
constexpr SamplingKernels sampling_kernels() {
  if constexpr (requires { typename Kind::Drawn; }) {
    return {&with_density<Fast, Kind, float>, &with_density<Reference, Kind, float>,
            &with_density<Reference, Kind, double>, &draw<Kind, float>, &draw<Kind, double>};
  } else {
    return {};
  }
}

template <class... Kinds>
constexpr std::array<SamplingKernels, sizeof...(Kinds)> all_kernels(TypeList<Kinds...>) {
  return {sampling_kernels<Kinds>()...};
}

constexpr auto kAnalytic = all_kernels(AllKinds{});

}  // namespace

extern const SamplingTable kSampling;  // NOLINT(readability-redundant-declaration): linkage
const SamplingTable kSampling{
    .analytic = kAnalytic.data(),
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
