#include "engine/evaluate.h"

#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <cassert>

#include "engine/kernel.h"
#include "engine/material_impl.h"
#include "engine/thread_pool.h"

namespace gonio {
namespace {

constexpr std::size_t kRun = 512;             // pairs that a kernel is given at a time
constexpr std::size_t kScratchValues = 2048;  // fits the first-level cache beside the directions
constexpr std::size_t kAlignment = 64;

// Results too small for a normal number become 0 while this lives: a lobe's tail is full of them,
// and each would cost a hundred cycles. Denormal inputs keep their value.
class FlushToZero {
 public:
  FlushToZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | _MM_FLUSH_ZERO_ON); }
  ~FlushToZero() { _mm_setcsr(before_); }
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
  unsigned before_;
};

template <class In>
struct InputScratch {
  alignas(kAlignment) In component[6][kRun];
};

template <class Out>
struct OutputScratch {
  alignas(kAlignment) Out values[kScratchValues];
  alignas(kAlignment) std::uint8_t flags[kRun];
};

const Layouts<float>& layouts(const KernelTable& table, float) { return table.layout32; }
const Layouts<double>& layouts(const KernelTable& table, double) { return table.layout64; }

Kernel<float, float> choose(const KernelSet& set, float, float) { return set.fast; }
Kernel<float, double> choose(const KernelSet& set, float, double) { return set.reference; }
Kernel<double, double> choose(const KernelSet& set, double, double) { return set.reference64; }

template <class T>
Directions<T> advanced(const Directions<T>& d, std::size_t by) {
  const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(by) * d.stride;
  return {d.x + offset, d.y + offset, d.z + offset, d.stride};
}

bool is_interleaved(const auto& d) { return d.stride == 3 && d.y == d.x + 1 && d.z == d.x + 2; }

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

template <class In, class Out>
std::uint8_t evaluate_run(const Material::Impl& material, const Batch<In, Out>& batch,
                          std::size_t begin, std::size_t n, const KernelTable& table) {
  const auto width = static_cast<std::size_t>(table.width);
  const std::size_t padded = (n + width - 1) / width * width;
  InputScratch<In> in_scratch;
  OutputScratch<Out> out_scratch;
  KernelInput<In> in{{}, {}, padded};
  lay_out(advanced(batch.wi, begin), n, padded, table, in_scratch.component, in.wi);
  lay_out(advanced(batch.wo, begin), n, padded, table, in_scratch.component + 3, in.wo);
  std::fill_n(out_scratch.flags, padded, std::uint8_t{0});

  const bool direct = n == padded && batch.values.pair_stride == 1;
  KernelOutput<Out> out{out_scratch.values, padded, out_scratch.flags, false};
  if (direct) {
    out.values = batch.values.data + begin;
    out.channel_stride = static_cast<std::size_t>(batch.values.channel_stride);
  }
  for (const MaterialPart& part : material.parts) {
    choose(part.kernels(table), In(), Out())(part.constants.get(), in, out);
    out.accumulate = true;
  }
  if (!direct) copy_values(out.values, padded, material.channels, n, table, batch.values, begin);
  std::uint8_t any = 0;
  for (std::size_t i = 0; i < n; ++i) any = static_cast<std::uint8_t>(any | out_scratch.flags[i]);
  if (batch.flags != nullptr) std::copy_n(out_scratch.flags, n, batch.flags + begin);
  return any;
}

template <class In, class Out>
std::uint8_t evaluate_span(const Material& material, const Batch<In, Out>& batch, std::size_t begin,
                           std::size_t end, Isa isa) {
  assert(is_supported(isa));
  const KernelTable& table = kernels(isa);
  const Material::Impl& impl = material.impl();
  const std::size_t by_channels =
      kScratchValues / static_cast<std::size_t>(impl.channels) / 16 * 16;
  const std::size_t run = std::min(kRun, by_channels);
  const FlushToZero flush;
  std::uint8_t any = 0;
  for (std::size_t at = begin; at < end; at += run) {
    any = static_cast<std::uint8_t>(any |
                                    evaluate_run(impl, batch, at, std::min(run, end - at), table));
  }
  return any;
}

template <class In, class Out>
std::uint8_t evaluate_parallel(const Material& material, const Batch<In, Out>& batch, Isa isa,
                               ThreadPool& pool) {
  // Waking a thread costs what a thousand pairs do.
  const std::size_t tile =
      std::clamp(batch.count / static_cast<std::size_t>(2 * pool.threads() + 2), std::size_t{1024},
                 kTilePairs);
  const std::size_t size = (tile + 15) / 16 * 16;
  const std::size_t tiles = (batch.count + size - 1) / size;
  if (tiles <= 1) return evaluate_span(material, batch, 0, batch.count, isa);
  std::atomic<std::uint8_t> any{0};
  pool.run(tiles, [&](std::size_t i) {
    any.fetch_or(
        evaluate_span(material, batch, i * size, std::min((i + 1) * size, batch.count), isa),
        std::memory_order_relaxed);
  });
  return any.load();
}

}  // namespace

std::uint8_t evaluate(const Material& m, const Batch<float, float>& b, Isa isa) {
  return evaluate_span(m, b, 0, b.count, isa);
}
std::uint8_t evaluate(const Material& m, const Batch<float, double>& b, Isa isa) {
  return evaluate_span(m, b, 0, b.count, isa);
}
std::uint8_t evaluate(const Material& m, const Batch<double, double>& b, Isa isa) {
  return evaluate_span(m, b, 0, b.count, isa);
}

std::uint8_t evaluate(const Material& m, const Batch<float, float>& b, Isa isa, ThreadPool& pool) {
  return evaluate_parallel(m, b, isa, pool);
}
std::uint8_t evaluate(const Material& m, const Batch<float, double>& b, Isa isa, ThreadPool& pool) {
  return evaluate_parallel(m, b, isa, pool);
}
std::uint8_t evaluate(const Material& m, const Batch<double, double>& b, Isa isa,
                      ThreadPool& pool) {
  return evaluate_parallel(m, b, isa, pool);
}

}  // namespace gonio
