// The sampling kernels of one instruction set, compiled like kernels.cpp.
#include <array>
#include <type_traits>

#include "engine/analytic_kernel.h"
#include "engine/number_kernel.h"
#include "engine/sampling_kernel.h"
#include "models/all.h"
#include "numeric/warp.h"

namespace gonio::GONIO_ISA {
namespace {

// The number system whose Real is stored as T.
template <class T>
using Numbers = std::conditional_t<std::is_same_v<T, float>, Fast, Reference>;

// The densities of a lobe, beside its values.
template <class N, class Kind>
struct DensityBeside {
  DensityOutput<typename N::Out> out;
  typename Kind::template Aim<N> aim[kBlock];

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
  DensityBeside<N, Kind> beside{density, {}};
  analytic_with<N, Kind>(constants, in, out, beside);
}

// Unit to the precision of Real.
template <class Real, class T>
GONIO_INLINE Vec3<Real> load_unit(const T* const (&component)[3], std::size_t i) {
  const Vec3<Real> w = load<Real>(component, i);
  const Real error = (w.z * w.z - Real(1)) + w.x * w.x + w.y * w.y;
  return Numbers<T>::inverse_length(error) * w;
}

// Whatever stands there, a number that a draw can work with.
template <class Real, class T>
GONIO_INLINE Real load_xi(const T* xi, std::size_t i) {
  return min(max(Real::load(xi + i), Real(0)),
             Real(std::is_same_v<T, float> ? 0x1.fffffep-1 : 0x1.fffffffffffffp-1));
}

template <class T, class DrawOne>
GONIO_INLINE void draw_with(const DrawRun<T>& run, const DrawOne& draw_one) {
  using Real = typename Numbers<T>::Real;
  const Real low(run.strategy - 0.5), high(run.strategy + 0.5);
  for (std::size_t i = 0; i < run.count; i += raw::kWidth) {
    const Xi<Real> xi{load_xi<Real>(run.xi[0], i), load_xi<Real>(run.xi[1], i),
                      load_xi<Real>(run.xi[2], i)};
    Vec3<Real> wo = draw_one(load_unit<Real>(run.wi, i), xi);
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
  const auto shape = static_cast<const Constants<Kind>*>(constants)->shape;
  draw_with(run, [&](const auto& wi, const auto& xi) {
    return Kind::Drawn::template draw<Numbers<T>>(shape, wi, xi);
  });
}

// By cos(theta_o) / pi.
template <class T>
void draw_cosine(const void*, const DrawRun<T>& run) {
  using Real = typename Numbers<T>::Real;
  draw_with(run, [](const auto&, const Xi<Real>& xi) {
    const auto phi = turn(xi.u);
    const Real radius = sqrt(xi.v);
    return Vec3<Real>{radius * phi.cos, radius * phi.sin, sqrt(Real(1) - xi.v)};
  });
}

template <class T>
void share(const MixtureTable& table, const ShareRun<T>& run) {
  using N = Numbers<T>;
  using Real = typename N::Real;
  using Wide = typename N::Wide;
  constexpr int kCells = MixtureTable::kNodes - 1;
  for (std::size_t i = 0; i < run.count; i += raw::kWidth) {
    const Real cos = min(max(load_unit<Real>(run.wi, i).z, Real(0)), Real(1));
    const Wide at = Wide(sqrt(cos)) * Wide(kCells), node = min(floor(at), Wide(kCells - 1));
    const Real weight = N::real(at - node);
    Real before(0), start[MixtureTable::kMaxLobes + 1], part[MixtureTable::kMaxLobes + 1];
    for (int k = 0; k < table.given; ++k) {
      const float* values = table.values + k * MixtureTable::kNodes;
      const Real a(gather(values, node)), b(gather(values + 1, node));
      start[k] = before;
      part[k] = a + weight * (b - a);
      part[k].store(run.shares[k] + i);
      before = before + part[k];
    }
    start[table.given] = before;
    part[table.given] = max(Real(1) - before, Real(0));
    part[table.given].store(run.shares[table.given] + i);
    if (run.xi == nullptr) continue;
    const Real xi = load_xi<Real>(run.xi, i);
    Real chosen(table.given);
    Real place = (xi - before) / max(part[table.given], Real(1e-30));
    for (int k = table.given - 1; k >= 0; --k) {
      const auto mine = xi < start[k] + part[k];
      chosen = select(mine, Real(k), chosen);
      place = select(mine, (xi - start[k]) / max(part[k], Real(1e-30)), place);
    }
    chosen.store(run.chosen + i);
    place.store(run.xi + i);
  }
}

template <class N, class In>
void finish(const FinishRun<In, typename N::Out>& run) {
  using Real = typename N::Real;
  constexpr double kInversePi = 0.318309886183790672;
  for (std::size_t i = 0; i < run.count; i += raw::kWidth) {
    const Vec3<Real> w = load<Real>(run.wo, i);
    const Real error = (w.z * w.z - Real(1)) + w.x * w.x + w.y * w.y;
    const Real cos = max(N::inverse_length(error) * w.z, Real(0));
    Real pdf = run.lobes ? Real::load(run.pdf + i) : Real(0);
    if (run.cosine) {
      const Real part = run.cosine_share != nullptr ? Real::load(run.cosine_share + i) : Real(1);
      pdf = pdf + part * (cos * Real(kInversePi));
    }
    pdf.store(run.pdf + i);
    const Real factor = select(Real(0) < pdf, cos / max(pdf, Real(1e-37)), Real(0));
    typename N::Out* at = run.values + i;
    for (int c = 0; c < run.channels; ++c, at += run.channel_stride)
      (Real::load(at) * factor).store(at);
  }
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
    .fast = &finish<Fast, float>,
    .reference = &finish<Reference, float>,
    .reference64 = &finish<Reference, double>,
};

}  // namespace gonio::GONIO_ISA
