// What the kernels compiled per instruction set offer for sampling: plain tables of functions.
//
// Nothing here has code: this header is read by objects of different instruction sets.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gonio/engine/isa.h"
#include "gonio/engine/random_numbers.h"
#include "kernels/kernel.h"

namespace gonio {

// The share of samples that each strategy of a mixture gets, by the angle of incidence: strategy k
// has values[k * kNodes + i] at cos(theta_i) = (i / (kNodes - 1))^2, linear in the root between.
// The last strategy gets the rest.
struct MixtureTable {
  static constexpr int kNodes = 17;
  static constexpr int kMaxLobes = 4;
  int given;  // strategies but the last
  float values[kMaxLobes * kNodes];
};

// Pair by pair: the densities of one lobe, times `share` where it is not null, stored or added.
template <class Out>
struct DensityOutput {
  Out* pdf;
  const Out* share;
  bool accumulate;
};

// A part's values and densities: what Kernel does, and the densities beside.
template <class In, class Out>
using DensityKernel = void (*)(const void* data, const KernelInput<In>&, const KernelOutput<Out>&,
                               const DensityOutput<Out>&);

// Where samples are drawn: separate components, the count a multiple of the packet's width. Only
// samples with chosen[i] == strategy are written, all if `chosen` is null.
template <class T>
struct DrawRun {
  const T* wi[3];
  const T* xi[3];
  const T* chosen;
  int strategy;
  std::size_t count;
  T* wo[3];
};
template <class T>
using Draw = void (*)(const void* data, const DrawRun<T>&);

// The shares of all strategies for each wi, strategy k's at shares[k]; and, if xi is not null,
// which one xi[i] chooses, xi[i] becoming its place in [0, 1) within the share.
template <class T>
struct ShareRun {
  const T* wi[3];
  std::size_t count;
  T* shares[MixtureTable::kMaxLobes + 1];
  T* xi;
  T* chosen;
};
template <class T>
using Share = void (*)(const MixtureTable&, const ShareRun<T>&);

// Adds cosine_share (1 if null and `cosine`) * cos(theta_o) / pi to the densities in `pdf`. If
// `flags` is not null the pairs are samples: values f become weights f cos(theta_o) / pdf, 0 where
// the pdf is 0, and the flags of those that are lost below the horizon are set, all others cleared.
template <class In, class Out>
struct FinishRun {
  const In* wi[3];
  const In* wo[3];
  std::size_t count, samples;  // of whole packets; of these, to be told of
  Out* pdf;
  bool cosine;  // whether the cosine is one of the strategies
  bool lobes;   // whether `pdf` holds densities of others
  const Out* cosine_share;
  Out* values;
  std::size_t channel_stride;
  int channels;
  std::uint8_t* flags;
};
struct Finished {
  std::uint64_t lost = 0;
  bool bad_wi = false;  // some wi cannot be used: their samples have the pdf 0, and no flag yet
};
template <class In, class Out>
using Finish = Finished (*)(const FinishRun<In, Out>&);

// Triples of numbers as separate components; whether all are in [0, 1).
template <class T>
using SplitNumbers = bool (*)(const T* xyz, std::size_t n, T* const (&xi)[3]);

template <class T>
using RandomNumbers = void (*)(const NumberSource&, std::uint64_t first, std::uint64_t per_wi,
                               std::size_t count, T* const (&xi)[3]);

// What a part draws samples with, beside its own values; all null for one that draws none.
struct SamplingKernels {
  DensityKernel<float, float> fast;  // eval and pdf together
  DensityKernel<float, double> reference;
  DensityKernel<double, double> reference64;
  Draw<float> draw32;
  Draw<double> draw64;
};

// Everything that a part offers in one instruction set.
struct PartKernels {
  EvalKernels eval;
  SamplingKernels sampling;
};

// Those of all kinds of one model.
template <std::size_t kKinds>
struct KernelArray {
  PartKernels of[kKinds];
};

struct SamplingTable {
  Draw<float> cosine32;
  Draw<double> cosine64;
  Share<float> share32;
  Share<double> share64;
  RandomNumbers<float> numbers32;
  RandomNumbers<double> numbers64;
  SplitNumbers<float> split32;
  SplitNumbers<double> split64;
  Finish<float, float> fast;
  Finish<float, double> reference;
  Finish<double, double> reference64;
};

namespace baseline {
extern const SamplingTable kSampling;
}
namespace avx2 {
extern const SamplingTable kSampling;
}
namespace avx512 {
extern const SamplingTable kSampling;
}

const SamplingTable& sampling_kernels(Isa isa);

}  // namespace gonio
