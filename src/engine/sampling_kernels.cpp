// The sampling kernels of one instruction set, compiled like kernels.cpp.
#include <array>
#include <type_traits>

#include "engine/analytic_kernel.h"
#include "engine/number_kernel.h"
#include "engine/sampling_kernel.h"
#include "models/all.h"
#include "numeric/twofold.h"

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

// Unit to the precision of Real.
template <class N, class T>
GONIO_INLINE Vec3<typename N::Real> load_unit(const T* const (&component)[3], std::size_t i) {
  using Real = typename N::Real;
  const Vec3<Real> w = load<Real>(component, i);
  return N::inverse_length(length_error(w)) * w;
}

template <class T, class DrawOne>
GONIO_INLINE void draw_with(const DrawRun<T>& run, const DrawOne& draw_one) {
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
  const auto shape = static_cast<const Constants<Kind>*>(constants)->shape;
  draw_with(run, [&](const auto& wi, const auto& xi) {
    return Kind::Drawn::template draw<DrawNumbers<T>>(shape, wi, xi);
  });
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

// An entry of a table with 16 of them, by a whole number.
GONIO_INLINE Float entry(const float* table, Float i) { return pick16(table, i); }
template <Exactness E>
GONIO_INLINE Double<E> entry(const float* table, Double<E> i) {
  return Double<E>(gather(table, i));
}

template <class T>
void share(const MixtureTable& table, const ShareRun<T>& run) {
  using N = Numbers<T>;
  using Real = typename N::Real;
  constexpr int kCells = MixtureTable::kNodes - 1;
  static_assert(kCells == 16);
  for (std::size_t i = 0; i < run.count; i += raw::kWidth) {
    const Real cos = min(max(load_unit<N>(run.wi, i).z, Real(0)), Real(1));
    const Real at = sqrt(cos) * Real(kCells);
    const Real node = min(round(at - Real(0.5)), Real(kCells - 1)), weight = at - node;
    Real before(0), start[MixtureTable::kMaxLobes], part[MixtureTable::kMaxLobes];
    for (int k = 0; k < table.given; ++k) {
      const float* values = table.values + k * MixtureTable::kNodes;
      const Real a = entry(values, node), b = entry(values + 1, node);
      start[k] = before;
      part[k] = a + weight * (b - a);
      part[k].store(run.shares[k] + i);
      before = before + part[k];
    }
    const Real rest = max(Real(1) - before, Real(0));
    rest.store(run.shares[table.given] + i);
    if (run.xi == nullptr) continue;
    const Real xi = Real::load(run.xi + i);
    Real chosen(table.given), from = before, width = rest;
    for (int k = table.given - 1; k >= 0; --k) {
      const auto mine = xi < start[k] + part[k];
      chosen = select(mine, Real(k), chosen);
      from = select(mine, start[k], from);
      width = select(mine, part[k], width);
    }
    chosen.store(run.chosen + i);
    ((xi - from) / max(width, Real(1e-30))).store(run.xi + i);
  }
}

// The lanes of a packet that hold one of `samples` samples, i the first's number.
GONIO_INLINE unsigned lanes_used(std::size_t i, std::size_t samples) {
  if (i + raw::kWidth <= samples) return kAllLanes;
  return i < samples ? (1U << (samples - i)) - 1 : 0;
}

template <class N, class In>
Finished finish(const FinishRun<In, typename N::Out>& run) {
  using Real = typename N::Real;
  constexpr double kInversePi = 0.318309886183790672;
  Finished finished;
  unsigned unfit = 0;
  for (std::size_t i = 0; i < run.count; i += raw::kWidth) {
    const Vec3<Real> wo = load<Real>(run.wo, i);
    const Real cos = max(N::inverse_length(length_error(wo)) * wo.z, Real(0));
    Real pdf = run.lobes ? Real::load(run.pdf + i) : Real(0);
    if (run.cosine) {
      const Real part = run.cosine_share != nullptr ? Real::load(run.cosine_share + i) : Real(1);
      pdf = pdf + part * (cos * Real(kInversePi));
    }
    if (run.flags == nullptr) {
      pdf.store(run.pdf + i);
      continue;
    }
    const Vec3<Real> wi = load<Real>(run.wi, i);
    const Mask fit = near_unit(length_error(wi)) & (Real(0) < wi.z);
    pdf = select(fit, pdf, Real(0));
    pdf.store(run.pdf + i);
    const Real factor = select(Real(0) < pdf, cos / max(pdf, Real(1e-37)), Real(0));
    typename N::Out* at = run.values + i;
    for (int c = 0; c < run.channels; ++c, at += run.channel_stride)
      (Real::load(at) * factor).store(at);
    const unsigned used = lanes_used(i, run.samples), usable = fit.bits();
    const unsigned lost = used & usable & ~(Real(0) < wo.z).bits();
    raw::store_bytes(run.flags + i, lost, flag::outgoing_below_horizon);
    finished.lost += static_cast<unsigned>(__builtin_popcount(lost));
    unfit |= used & ~usable;
  }
  finished.bad_wi = unfit != 0;
  return finished;
}

template <class T>
bool split_numbers(const T* __restrict xyz, std::size_t n, T* const (&xi)[3]) {
  std::size_t i = 0;
  unsigned good = kAllLanes;
  if constexpr (std::is_same_v<T, float>) {
    for (; i + raw::kWidth <= n; i += raw::kWidth) {
      Float x, y, z;
      fetch_ahead(xyz + 3 * i);
      raw::split3(xyz + 3 * i, x.v, y.v, z.v);
      x.store(xi[0] + i), y.store(xi[1] + i), z.store(xi[2] + i);
      // min may lose a NaN, but then a comparison with 1 fails.
      const Mask below1 = (x < Float(1)) & (y < Float(1)) & (z < Float(1));
      good &= below1.bits() & ~(min(min(x, y), z) < Float(0)).bits();
    }
  }
  bool rest = true;
  for (; i < n; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const T x = xi[c][i] = xyz[3 * i + c];
      rest = rest && x >= 0 && x < 1;
    }
  }
  return rest && good == kAllLanes;
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
