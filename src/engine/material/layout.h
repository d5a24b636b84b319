// Between the layouts that callers use and the one that kernels read and write.
#pragma once

#include <algorithm>
#include <cstddef>

#include "gonio/engine/evaluate.h"
#include "kernels/kernel.h"

namespace gonio {

inline const Layouts<float>& layouts(const KernelTable& table, float) { return table.layout32; }
inline const Layouts<double>& layouts(const KernelTable& table, double) { return table.layout64; }

template <class T>
Directions<T> advanced(const Directions<T>& d, std::size_t by) {
  const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(by) * d.stride;
  return {d.x + offset, d.y + offset, d.z + offset, d.stride};
}

inline bool is_interleaved(const auto& d) {
  return d.stride == 3 && d.y == d.x + 1 && d.z == d.x + 2;
}

// Directions as separate components, the last repeated up to `padded`: copied to `to` unless they
// lie so already.
template <class In>
void lay_out(const Directions<In>& d, std::size_t n, std::size_t padded, const KernelTable& table,
             In (*to)[kRun], const In* (&out)[3]) {
  if (d.stride == 1 && n == padded) {
    out[0] = d.x, out[1] = d.y, out[2] = d.z;
    return;
  }
  if (is_interleaved(d)) {
    layouts(table, In()).split(d.x, n, to[0], to[1], to[2]);
  } else {
    for (std::size_t i = 0; i < n; ++i) {
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * d.stride;
      to[0][i] = d.x[at], to[1][i] = d.y[at], to[2][i] = d.z[at];
    }
  }
  for (int c = 0; c < 3; ++c) {
    std::fill(to[c] + n, to[c] + padded, to[c][n - 1]);
    out[c] = to[c];
  }
}

template <class Out>
void copy_values(const Out* from, std::size_t stride, int channels, std::size_t n,
                 const KernelTable& table, const Values<Out>& to, std::size_t begin) {
  Out* data = to.data + static_cast<std::ptrdiff_t>(begin) * to.pair_stride;
  if (to.channel_stride == 1 && to.pair_stride == channels) {
    layouts(table, Out()).join(from, stride, channels, n, data);
    return;
  }
  for (int c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < n; ++i) {
      data[static_cast<std::ptrdiff_t>(i) * to.pair_stride + c * to.channel_stride] =
          from[static_cast<std::size_t>(c) * stride + i];
    }
  }
}

}  // namespace gonio
