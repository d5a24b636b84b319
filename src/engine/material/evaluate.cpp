#include "gonio/engine/evaluate.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstdint>
#include <type_traits>

#include "engine/material/flush_to_zero.h"
#include "engine/material/layout.h"
#include "engine/material/material_impl.h"
#include "gonio/engine/thread_pool.h"
#include "kernels/choose.h"

namespace gonio {
namespace {

constexpr std::size_t kScratchValues = 8192;  // a kernel's block of the most channels
constexpr std::size_t kAlignment = 64;
constexpr std::size_t kSmallestTile = 1024;  // pairs worth handing to another thread that is awake
constexpr std::size_t kBriefPairs = 12'000;  // done within the time that waking a thread takes

template <class In>
struct InputScratch {
  alignas(kAlignment) In component[6][kRun];
};

template <class Out>
struct OutputScratch {
  alignas(kAlignment) Out values[kScratchValues];
  alignas(kAlignment) std::uint8_t flags[kRun];
};

template <class In, class Out>
std::uint8_t evaluate_run(const Material::Impl& material, const Batch<In, Out>& batch,
                          std::size_t begin, std::size_t n, Isa isa) {
  const KernelTable& table = kernels(isa);
  const auto width = static_cast<std::size_t>(table.width);
  const std::size_t padded = (n + width - 1) / width * width;
  InputScratch<In> in_scratch;
  OutputScratch<Out> out_scratch;
  KernelInput<In> in{{}, {}, padded};
  lay_out(advanced(batch.wi, begin), n, padded, table, in_scratch.component, in.wi);
  lay_out(advanced(batch.wo, begin), n, padded, table, in_scratch.component + 3, in.wo);
  std::fill_n(out_scratch.flags, padded, std::uint8_t{0});

  const bool direct = n == padded && batch.values.pair_stride == 1;
  KernelOutput<Out> out{out_scratch.values, padded, out_scratch.flags, false, true};
  if (direct) {
    out.values = batch.values.data + begin;
    out.channel_stride = static_cast<std::size_t>(batch.values.channel_stride);
  }
  for (const Part& part : material.parts) {
    kernel_of(part.kind->kernels(isa).eval, In(), Out())(part.made.data.get(), in, out);
    out.accumulate = true;
  }
  if (!direct) copy_values(out.values, padded, material.channels, n, table, batch.values, begin);
  std::uint8_t any = 0;
  for (std::size_t i = 0; i < n; ++i) any = static_cast<std::uint8_t>(any | out_scratch.flags[i]);
  if (batch.flags != nullptr) std::copy_n(out_scratch.flags, n, batch.flags + begin);
  return any;
}

// Pairs from `begin` to where the first channel's results lie at a cache line's start.
template <class Out>
std::size_t pairs_to_alignment(const Values<Out>& values, std::size_t begin) {
  if (values.pair_stride != 1) return 0;
  const auto address = reinterpret_cast<std::uintptr_t>(values.data + begin);
  return (kAlignment - address % kAlignment) % kAlignment / sizeof(Out);
}

template <class In, class Out>
std::uint8_t evaluate_span(const Material& material, const Batch<In, Out>& batch, std::size_t begin,
                           std::size_t end, Isa isa) {
  assert(is_supported(isa));
  const Material::Impl& impl = material.impl();
  const std::size_t by_channels =
      kScratchValues / static_cast<std::size_t>(impl.channels) / kGrain * kGrain;
  // Only results that are copied need room in between.
  const std::size_t run = batch.values.pair_stride == 1 ? kRun : std::min(kRun, by_channels);
  const bool uncopied = batch.wi.stride == 1 && batch.wo.stride == 1;
  const FlushToZero flush;
  std::uint8_t any = 0;
  for (std::size_t at = begin, n = 0; at < end; at += n) {
    const std::size_t lead = pairs_to_alignment(batch.values, at), left = end - at;
    n = std::min(lead > 0 ? lead : run, left);
    // What is no whole number of packets is padded, in a copy: so the rest comes by itself.
    if (n > kGrain && (uncopied || n > by_channels)) n = n / kGrain * kGrain;
    any = static_cast<std::uint8_t>(any | evaluate_run(impl, batch, at, n, isa));
  }
  return any;
}

template <class In, class Out>
std::uint8_t evaluate_parallel(const Material& material, const Batch<In, Out>& batch, Isa isa,
                               ThreadPool& pool) {
  // Two tiles a thread even out what else the machine does; but small ones cost more than they do.
  const auto sharers = static_cast<std::size_t>(pool.threads()) + 1;
  const std::size_t fair = batch.count / (batch.count < kBriefPairs ? sharers : 2 * sharers);
  const std::size_t size =
      (std::clamp(fair, kSmallestTile, kTilePairs) + kGrain - 1) / kGrain * kGrain;
  const std::size_t lead = pairs_to_alignment(batch.values, 0);
  const std::size_t tiles = batch.count <= lead ? 1 : (batch.count - lead + size - 1) / size;
  std::atomic<std::uint8_t> any{0};
  const auto tile = [&](std::size_t i) {
    const std::size_t begin = i == 0 ? 0 : lead + i * size;
    const std::size_t end = std::min(lead + (i + 1) * size, batch.count);
    any.fetch_or(evaluate_span(material, batch, begin, end, isa), std::memory_order_relaxed);
  };
  pool.run(tiles, tile, batch.count < kBriefPairs);
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
