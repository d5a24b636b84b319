// What the kernels compiled per instruction set offer to the rest of the engine: plain tables of
// functions.
//
// Nothing here has code: this header is read by objects of different instruction sets.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gonio/engine/isa.h"

namespace gonio {

inline constexpr std::size_t kRun = 512;   // pairs that a kernel is given at a time
inline constexpr std::size_t kGrain = 16;  // pairs of the widest packet

// A run of pairs as the kernels take it: separate, contiguous components; the count a multiple of
// the packet's width.
template <class In>
struct KernelInput {
  const In* wi[3];
  const In* wo[3];
  std::size_t count;
};

// Channel c of pair i goes to values[c * channel_stride + i]. Flags of bad pairs are written, those
// of good ones are not touched. With `accumulate` the values are added to what is there. With
// `tell_holes` pairs that met a hole of a table are flagged, too.
template <class Out>
struct KernelOutput {
  Out* values;
  std::size_t channel_stride;
  std::uint8_t* flags;
  bool accumulate;
  bool tell_holes = false;
};

// What one function does with a run of pairs. `data` is what the part was prepared as: for an
// analytic model a Constants (constants.h).
template <class In, class Out>
using Kernel = void (*)(const void* data, const KernelInput<In>&, const KernelOutput<Out>&);

// Evaluation, by precision and the type of the directions. Derivatives have no `fast`.
struct EvalKernels {
  Kernel<float, float> fast;
  Kernel<float, double> reference;
  Kernel<double, double> reference64;
};

// Between interleaved and separate components: n triples, and n pairs of `channels` values.
template <class T>
struct Layouts {
  void (*split)(const T* xyz, std::size_t n, T* x, T* y, T* z);
  void (*join)(const T* planar, std::size_t channel_stride, int channels, std::size_t n,
               T* interleaved);
};

// What one instruction set offers whatever is evaluated.
struct KernelTable {
  int width;  // lanes of a packet
  Layouts<float> layout32;
  Layouts<double> layout64;
};

namespace baseline {
extern const KernelTable kKernels;
}
namespace avx2 {
extern const KernelTable kKernels;
}
namespace avx512 {
extern const KernelTable kKernels;
}

const KernelTable& kernels(Isa isa);

}  // namespace gonio
