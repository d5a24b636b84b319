// What is done with samples of all strategies together, of one instruction set: choosing among the
// strategies before they draw, and weighing what has been drawn and evaluated.
#pragma once

#include <type_traits>

#include "kernels/packet_io.h"
#include "kernels/sampling_kernel.h"

namespace gonio::GONIO_ISA {

// The number system whose Real is stored as T.
template <class T>
using Numbers = std::conditional_t<std::is_same_v<T, float>, Fast, Reference>;

// Unit to the precision of Real.
template <class N, class T>
GONIO_INLINE Vec3<typename N::Real> load_unit(const T* const (&component)[3], std::size_t i) {
  using Real = typename N::Real;
  const Vec3<Real> w = load<Real>(component, i);
  return N::inverse_length(length_error(w)) * w;
}

// An entry of a table with 16 of them, by a whole number.
GONIO_INLINE Float entry(const float* table, Float i) { return pick16(table, i); }
template <Exactness E>
GONIO_INLINE Double<E> entry(const float* table, Double<E> i) {
  return Double<E>(gather(table, i));
}

template <class T>
void share(const MixtureTable& table, const ShareRun<T>& given) {
  const auto run = given;  // a copy that no store can alias
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
Finished finish(const FinishRun<In, typename N::Out>& given) {
  const auto run = given;  // a copy that no store can alias
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

}  // namespace gonio::GONIO_ISA
