// A kernel's way through the steps of an analytic model: stage (from the geometry), refine (what
// needs float64), terms (what all channels share), value (of a channel), for blocks of packets.
// There is no remainder loop: callers pad, so that a pair's result cannot depend on where in a
// batch it stands.
#pragma once

#include "kernels/constants.h"
#include "kernels/kernel.h"
#include "kernels/packet_io.h"
#include "numeric/dual.h"
#include "numeric/number.h"
#include "parts/geometry.h"

namespace gonio::GONIO_ISA {

// Packets taken through one step at a time. The whole chain of one packet is longer than what a
// processor can look ahead, so it would wait for itself; a step is short enough that several
// packets overlap.
constexpr std::size_t kBlock = 8;

template <class N, class Kind>
struct Block {
  typename N::Mask valid[kBlock];
  typename Kind::template Stage<N> stage[kBlock];
  typename Kind::template Refined<N> refined[kBlock];
  typename Kind::template Terms<N> terms[kBlock];
};

// What a packet adds to the values of lobes before, or to their derivatives, which are all that is
// stored of dual numbers.
template <class Real, class Out>
GONIO_INLINE Real added(const Real& value, const Out* to) {
  return value + Real::load(to);
}
template <class Number, class Out>
GONIO_INLINE Dual<Number> added(const Dual<Number>& value, const Out* to) {
  return {value.v, value.d + Number::load(to)};
}

// One channel of a packet.
template <bool kAccumulate, class N, class Kind>
GONIO_INLINE void write_value(const Block<N, Kind>& block, std::size_t p,
                              const Constants<Kind, typename N::WideScalar>& constants, int c,
                              typename N::Out* to) {
  using Real = typename N::Real;
  const Real value = Kind::template eval<N>(block.terms[p], constants.wide[c],
                                            constants.template channel<typename N::RealScalar>(c));
  Real result = select(block.valid[p], min(N::largest(), value), Real(0));
  if constexpr (kAccumulate) result = min(N::largest(), added(result, to));
  result.store(to);
}

// More channels than this are written one after the other, not packet by packet: so many streams at
// once, mostly a power of two apart, would push each other out of the cache.
constexpr int kFewChannels = 4;

// All channels of a block's packets, from pair `begin` on.
template <bool kAccumulate, class N, class Kind>
GONIO_INLINE void write(const Block<N, Kind>& block,
                        const Constants<Kind, typename N::WideScalar>& constants, std::size_t begin,
                        std::size_t packets, const KernelOutput<typename N::Out>& out) {
  const int channels = constants.channels;
  const std::size_t stride = out.channel_stride;
  typename N::Out* packet = out.values + begin;
  if (channels > kFewChannels) {
    for (int c = 0; c < channels; ++c, packet += stride) {
      for (std::size_t p = 0; p < packets; ++p)
        write_value<kAccumulate>(block, p, constants, c, packet + p * raw::kWidth);
    }
    return;
  }
  for (std::size_t p = 0; p < packets; ++p, packet += raw::kWidth) {
    typename N::Out* to = packet;
    for (int c = 0; c < channels; ++c, to += stride) {
      write_value<kAccumulate>(block, p, constants, c, to);
      __builtin_prefetch(to + kAheadOfWriting);
    }
  }
}

template <class N, class Kind, class In>
[[gnu::noinline]] void note_block(const Block<N, Kind>& block, std::size_t packets,
                                  const KernelInput<In>& in, std::size_t begin,
                                  std::uint8_t* flags) {
  for (std::size_t p = 0; p < packets; ++p) {
    const unsigned valid = block.valid[p].bits();
    if (valid != kAllLanes) note_flags(in, begin + p * raw::kWidth, valid, flags);
  }
}

// The first step of a block's packets, seen from the material's tangents if these are turned; which
// lanes are valid in all of them.
template <bool kTurned, class N, class Kind, class In, class Beside>
GONIO_INLINE unsigned stage_block(
    const Constants<Kind, typename N::WideScalar>& given,
    const typename Kind::template Shape<typename N::WideScalar>& shape, const KernelInput<In>& in,
    std::size_t begin, std::size_t packets, Block<N, Kind>& block, Beside& beside) {
  unsigned valid = kAllLanes;
  for (std::size_t p = 0; p < packets; ++p) {
    Geometry<N> g = load_geometry<N>(in, begin + p * raw::kWidth);
    if constexpr (kTurned) g.turn(given.tangents.rotation);
    block.valid[p] = g.valid;
    valid &= g.valid.bits();
    block.stage[p] = Kind::template stage<N>(shape, g);
    beside.stage(p, shape, g);
  }
  return valid;
}

template <class Kind, class S>
GONIO_INLINE bool is_turned(const Constants<Kind, S>& given) {
  if constexpr (has_tangents<Kind>()) {
    return given.tangents.turned;
  } else {
    return false;
  }
}

// `beside` sees each packet's geometry, and each block's terms: sampling adds its densities there.
template <class N, class Kind, class In, class Beside>
GONIO_INLINE void analytic_with(const void* constants, const KernelInput<In>& in,
                                const KernelOutput<typename N::Out>& out, Beside& beside) {
  const auto& given = *static_cast<const Constants<Kind, typename N::WideScalar>*>(constants);
  // A copy that no store can alias, so that it stays in registers.
  const auto shape = given.shape;
  [[maybe_unused]] const bool turned = is_turned(given);
  Block<N, Kind> block;
  for (std::size_t begin = 0; begin < in.count; begin += kBlock * raw::kWidth) {
    // Not std::min: without optimisation it would be a symbol that objects of all instruction sets
    // share.
    const std::size_t left = (in.count - begin) / raw::kWidth;
    const std::size_t packets = left < kBlock ? left : kBlock;
    unsigned valid = 0;
    if constexpr (has_tangents<Kind>()) {
      valid = turned ? stage_block<true>(given, shape, in, begin, packets, block, beside)
                     : stage_block<false>(given, shape, in, begin, packets, block, beside);
    } else {
      valid = stage_block<false>(given, shape, in, begin, packets, block, beside);
    }
    for (std::size_t p = 0; p < packets; ++p)
      block.refined[p] = Kind::template refine<N>(shape, block.stage[p]);
    for (std::size_t p = 0; p < packets; ++p)
      block.terms[p] = Kind::template terms<N>(shape, block.stage[p], block.refined[p]);
    if (valid != kAllLanes) note_block<N, Kind>(block, packets, in, begin, out.flags);
    if (out.accumulate) {
      write<true>(block, given, begin, packets, out);
    } else {
      write<false>(block, given, begin, packets, out);
    }
    for (std::size_t p = 0; p < packets; ++p) beside.finish(p, shape, block, begin);
  }
}

}  // namespace gonio::GONIO_ISA
