// Evaluating a measured table (lookup.h): the nearest cell, or between the eight around.
//
// Invalid cells hold NaN: their weight goes to the valid ones among the eight; where there are none
// the value is 0 and the pair is flagged. A pair whose value is partly taken from holes of the
// table has a flag of its own, if that is asked for.
#pragma once

#include "kernels/kernel.h"
#include "kernels/packet_io.h"
#include "measured/merl/constants.h"
#include "measured/merl/lookup.h"

namespace gonio::GONIO_ISA {

// The rare path: pairs that a measured table knows nothing of.
[[gnu::noinline]] static void note_outside(std::size_t i, unsigned outside, std::uint8_t* flags) {
  if (flags == nullptr) return;
  for (std::size_t lane = 0; lane < raw::kWidth; ++lane) {
    if ((outside >> lane & 1U) != 0) flags[i + lane] = flag::outside_data;
  }
}

// Pairs that look into a cell from which a hole is met.
template <class Wide>
GONIO_INLINE void note_holes(std::size_t i, unsigned known, Wide cell, const std::uint64_t* holes,
                             std::uint8_t* flags) {
  alignas(64) double cells[raw::kWidth];
  cell.store(cells);
  for (std::size_t lane = 0; lane < raw::kWidth; ++lane) {
    const auto at = static_cast<std::size_t>(static_cast<std::int32_t>(cells[lane]));
    const auto met = static_cast<unsigned>(holes[at / 64] >> (at % 64)) & (known >> lane) & 1U;
    flags[i + lane] = static_cast<std::uint8_t>(flags[i + lane] | met * flag::hole);
  }
}

template <class N, bool kLinear, class In>
void look_up(const void* constants, const KernelInput<In>& in,
             const KernelOutput<typename N::Out>& out) {
  using Real = typename N::Real;
  const auto& [table, holes] = *static_cast<const merl::Constants*>(constants);
  const bool tell_holes = out.tell_holes && holes != nullptr;
  constexpr int kCorners = kLinear ? 8 : 1;
  for (std::size_t i = 0; i < in.count; i += raw::kWidth) {
    const Geometry<N> g = load_geometry<N>(in, i);
    const unsigned valid = g.valid.bits();
    if (valid != kAllLanes) note_flags(in, i, valid, out.flags);
    TablePosition<N> at = locate(g);
    // Lanes without a position must still read inside the table.
    at = {select(g.valid, at.h, 0), select(g.valid, at.d, 0), select(g.valid, at.p, 0)};
    Corner<N> corner[kCorners];
    find_corners(at, corner);
    Real total(0), sum(0);
    for (auto& k : corner) {
      const Real value = fetch<N>(table, k.index, 0);
      k.weight = select(Real(-1) < value, k.weight, Real(0));  // false for NaN
      total = total + k.weight;
      sum = sum + k.weight * max(value, Real(0));  // max gives 0 for NaN
    }
    const auto known = g.valid & (Real(0) < total);
    if ((known.bits() ^ valid) != 0) note_outside(i, known.bits() ^ valid, out.flags);
    if (tell_holes) note_holes(i, known.bits(), corner[0].index, holes, out.flags);
    const Real norm = Real(1) / select(known, total, Real(1));
    for (int c = 0; c < MeasuredTable::kChannels; ++c) {
      if (c > 0) {
        sum = Real(0);
        for (const auto& k : corner)
          sum = sum + k.weight * max(fetch<N>(table, k.index, c), Real(0));
      }
      select(known, sum * norm, Real(0))
          .store(out.values + static_cast<std::size_t>(c) * out.channel_stride + i);
    }
  }
}

}  // namespace gonio::GONIO_ISA
