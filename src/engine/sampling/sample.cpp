// Drawing batches of samples.
#include <cassert>

#include "engine/material/flush_to_zero.h"
#include "engine/sampling/sampling_run.h"
#include "kernels/direction_flags.h"

namespace gonio {
namespace {

using sampling::kAlignment;
using sampling::padded_to;
using sampling::Run;
using sampling::run_length;
using sampling::Scratch;

// The numbers of samples, and which of them are bad.
template <class T>
struct Numbers {
  alignas(kAlignment) T xi[3][kRun];
  alignas(kAlignment) T chosen[kRun];

  void load(const SampleBatch<T>& batch, std::size_t begin, std::size_t n, std::size_t padded,
            const SamplingTable& table) {
    T* const to[3] = {xi[0], xi[1], xi[2]};
    any_bad_ = false;
    if (batch.xi == nullptr) {
      random_numbers(batch.numbers, batch.first + begin, batch.per_wi, n, to);
    } else if (!split_of(table, T())(batch.xi + 3 * begin, n, to)) {
      set_bad_aside(n);
    }
    for (T* x : to) std::fill(x + n, x + padded, T(0));
  }
  [[nodiscard]] bool any_bad() const { return any_bad_; }
  [[nodiscard]] std::uint8_t flags_of(std::size_t i) const { return any_bad_ ? bad_[i] : 0; }

 private:
  static bool is_number(T x) { return x >= 0 && x < 1; }
  // Draws get numbers that they can work with.
  void set_bad_aside(std::size_t n) {
    any_bad_ = true;
    for (std::size_t i = 0; i < n; ++i) {
      const bool good = is_number(xi[0][i]) && is_number(xi[1][i]) && is_number(xi[2][i]);
      bad_[i] = good ? 0 : flag::bad_number;
      if (!good) xi[0][i] = xi[1][i] = xi[2][i] = 0;
    }
  }
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

// A run with a bad wi or number, which leave no direction and are all that the flag of their sample
// tells of, or of a measured table. Counts the flags anew.
template <class T>
SampleReport settle(std::size_t n, const Numbers<T>& numbers, Run<T, T>& run,
                    Scratch<T, T>& scratch) {
  SampleReport report;
  for (std::size_t i = 0; i < n; ++i) {
    const auto bad =
        static_cast<std::uint8_t>(direction_flags(scratch.wi[0][i], scratch.wi[1][i],
                                                  scratch.wi[2][i], flag::incident_below_horizon) |
                                  numbers.flags_of(i));
    if (bad != 0) {
      scratch.flags[i] = bad;
      for (auto& component : scratch.wo) component[i] = 0;
      run.clear(i);
    }
    report.any_flags |= scratch.flags[i];
    report.lost += bad == 0 && scratch.flags[i] != 0 ? 1 : 0;
  }
  return report;
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
    n = std::min(run_length(sampler, batch.count), batch.count - begin);
    const std::size_t padded = padded_to(table, n);
    Run<T, T> run(sampler, isa, padded, scratch);
    repeat_wi(batch, begin, n, padded, table, scratch.wi);
    numbers.load(batch, begin, n, padded, sampling_kernels(isa));
    const T* const wi[3] = {scratch.wi[0], scratch.wi[1], scratch.wi[2]};
    run.share(wi, numbers.xi[0], numbers.chosen);
    run.draw({{wi[0], wi[1], wi[2]},
              {numbers.xi[0], numbers.xi[1], numbers.xi[2]},
              numbers.chosen,
              0,
              padded,
              {scratch.wo[0], scratch.wo[1], scratch.wo[2]}});
    const Finished finished = run.weigh(
        {{wi[0], wi[1], wi[2]}, {scratch.wo[0], scratch.wo[1], scratch.wo[2]}, padded}, n);
    SampleReport here{finished.lost > 0 ? flag::outgoing_below_horizon : std::uint8_t{0},
                      finished.lost};
    if (finished.bad_wi || numbers.any_bad() || sampler.impl().has_gaps)
      here = settle(n, numbers, run, scratch);
    report.any_flags |= here.any_flags;
    report.lost += here.lost;
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
