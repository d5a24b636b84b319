// Drawing batches of samples.
#include <bit>
#include <cassert>

#include "engine/direction_flags.h"
#include "engine/flush_to_zero.h"
#include "engine/sampling_run.h"

namespace gonio {
namespace {

using namespace sampling;

// The numbers of samples, by which bad ones are found.
template <class T>
struct Numbers {
  alignas(kAlignment) T xi[3][kRun];
  alignas(kAlignment) T chosen[kRun];

  void load(const SampleBatch<T>& batch, std::size_t begin, std::size_t n, std::size_t padded,
            const KernelTable& table) {
    T* const to[3] = {xi[0], xi[1], xi[2]};
    if (batch.xi == nullptr) {
      random_numbers(batch.numbers, batch.first + begin, batch.per_wi, n, to);
    } else {
      layouts(table, T()).split(batch.xi + 3 * begin, n, xi[0], xi[1], xi[2]);
    }
    for (T* x : to) std::fill(x + n, x + padded, T(0));
  }

  // Notes which of the numbers as given are not in [0, 1).
  void note_bad(std::size_t n) {
    // The bits of numbers in [0, 1), read as a whole number, are those below the bits of 1.
    using Bits = std::conditional_t<std::is_same_v<T, float>, std::uint32_t, std::uint64_t>;
    Bits suspect = 0;
    for (const auto& x : xi) {
      for (std::size_t i = 0; i < n; ++i)
        suspect |= static_cast<Bits>(std::bit_cast<Bits>(x[i]) >= std::bit_cast<Bits>(T(1)));
    }
    any_bad_ = suspect != 0;
    if (!any_bad_) return;
    for (std::size_t i = 0; i < n; ++i)
      bad_[i] =
          is_number(xi[0][i]) && is_number(xi[1][i]) && is_number(xi[2][i]) ? 0 : flag::bad_number;
  }
  void add_flags(std::size_t n, std::uint8_t* flags) const {
    if (!any_bad_) return;
    for (std::size_t i = 0; i < n; ++i) flags[i] |= bad_[i];
  }
  [[nodiscard]] std::uint8_t flags_of(std::size_t i) const { return any_bad_ ? bad_[i] : 0; }

 private:
  static bool is_number(T x) { return x >= 0 && x < 1; }
  bool any_bad_ = false;
  std::uint8_t bad_[kRun]{};
};

// Each wi repeated for its samples.
template <class T>
void repeat_wi(const SampleBatch<T>& batch, std::size_t begin, std::size_t n, std::size_t padded,
               const KernelTable& table, T (&to)[3][kRun]) {
  const std::uint64_t sample = batch.first + begin, first = sample / batch.per_wi;
  const Directions<T> wi =
      advanced(batch.wi, static_cast<std::size_t>(first - batch.first / batch.per_wi));
  if (batch.per_wi == 1) {
    const T* unused[3];
    lay_out(Directions<T>{wi.x, wi.y, wi.z, wi.stride}, n, padded, table, to, unused);
    for (int c = 0; c < 3; ++c)
      if (unused[c] != to[c]) std::copy_n(unused[c], padded, to[c]);
    return;
  }
  std::uint64_t left = (first + 1) * batch.per_wi - sample;  // of this wi
  std::ptrdiff_t at = 0;
  for (std::size_t i = 0; i < n; at += wi.stride, left = batch.per_wi) {
    const auto run = static_cast<std::size_t>(std::min<std::uint64_t>(left, n - i));
    std::fill_n(to[0] + i, run, wi.x[at]);
    std::fill_n(to[1] + i, run, wi.y[at]);
    std::fill_n(to[2] + i, run, wi.z[at]);
    i += run;
  }
  for (auto& component : to) std::fill(component + n, component + padded, component[n - 1]);
}

// Of the samples that were flagged: a bad wi or number leaves no direction, and is all that the
// flag tells of; one that was drawn below the horizon keeps its direction.
template <class T>
std::uint8_t settle_flagged(std::size_t n, const Numbers<T>& numbers, Scratch<T, T>& scratch,
                            std::uint64_t& lost) {
  std::uint8_t any = 0;
  for_flagged(scratch.flags, n, [&](std::size_t i) {
    const auto bad =
        static_cast<std::uint8_t>(direction_flags(scratch.wi[0][i], scratch.wi[1][i],
                                                  scratch.wi[2][i], flag::incident_below_horizon) |
                                  numbers.flags_of(i));
    scratch.flags[i] = bad != 0 ? bad : flag::outgoing_below_horizon;
    any = static_cast<std::uint8_t>(any | scratch.flags[i]);
    if (bad == 0) {
      ++lost;
    } else {
      for (auto& component : scratch.wo) component[i] = 0;
    }
  });
  return any;
}

template <class T>
SampleReport sample_all(const Sampler& sampler, const SampleBatch<T>& batch, Isa isa) {
  assert(is_supported(isa));
  const FlushToZero flush;
  const KernelTable& table = kernels(isa);
  Scratch<T, T> scratch;
  Numbers<T> numbers;
  SampleReport report;
  for (std::size_t begin = 0, n = 0; begin < batch.count; begin += n) {
    n = std::min(run_length(sampler), batch.count - begin);
    const std::size_t padded = padded_to(table, n);
    Run<T, T> run(sampler, isa, padded, scratch);
    repeat_wi(batch, begin, n, padded, table, scratch.wi);
    numbers.load(batch, begin, n, padded, table);
    if (batch.xi != nullptr) numbers.note_bad(n);
    const T* const wi[3] = {scratch.wi[0], scratch.wi[1], scratch.wi[2]};
    run.share(wi, numbers.xi[0], numbers.chosen);
    run.draw({{wi[0], wi[1], wi[2]},
              {numbers.xi[0], numbers.xi[1], numbers.xi[2]},
              numbers.chosen,
              0,
              padded,
              {scratch.wo[0], scratch.wo[1], scratch.wo[2]}});
    run.evaluate({{wi[0], wi[1], wi[2]}, {scratch.wo[0], scratch.wo[1], scratch.wo[2]}, padded},
                 true);
    if (batch.xi != nullptr) numbers.add_flags(n, scratch.flags);
    if (run.clear_flagged(n) != 0)
      report.any_flags |= settle_flagged(n, numbers, scratch, report.lost);
    copy_values(scratch.wo[0], kRun, 3, n, table, Values<T>::interleaved(batch.wo, 3), begin);
    std::copy_n(scratch.pdf, n, batch.pdf + begin);
    if (batch.weights.data != nullptr)
      copy_values(scratch.values, padded, sampler.material().channels(), n, table, batch.weights,
                  begin);
    if (batch.flags != nullptr) std::copy_n(scratch.flags, n, batch.flags + begin);
  }
  return report;
}

}  // namespace

SampleReport sample(const Sampler& s, const SampleBatch<float>& b, Isa isa) {
  return sample_all(s, b, isa);
}
SampleReport sample(const Sampler& s, const SampleBatch<double>& b, Isa isa) {
  return sample_all(s, b, isa);
}

}  // namespace gonio
