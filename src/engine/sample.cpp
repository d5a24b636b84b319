// Runs of samples, and of pairs with their densities, through the sampling kernels.
#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

#include "engine/direction_flags.h"
#include "engine/flush_to_zero.h"
#include "engine/layout.h"
#include "engine/strategies.h"

namespace gonio {
namespace {

constexpr std::size_t kAlignment = 64;
constexpr std::size_t kMaxStrategies = MixtureTable::kMaxLobes + 1;
constexpr std::size_t kScratchValues = 8192;  // pairs x channels; at least kGrain of the most
constexpr std::size_t kGrain = 16;            // pairs of the widest packet

template <class In, class Out>
struct Scratch {
  alignas(kAlignment) In wi[3][kRun];
  alignas(kAlignment) In wo[3][kRun];
  alignas(kAlignment) Out shares[kMaxStrategies][kRun];
  alignas(kAlignment) Out pdf[kRun];
  alignas(kAlignment) Out values[kScratchValues];
  alignas(kAlignment) std::uint8_t flags[kRun];
};

std::size_t padded_to(const KernelTable& table, std::size_t n) {
  const auto width = static_cast<std::size_t>(table.width);
  return (n + width - 1) / width * width;
}

// Calls back with the number of each flagged pair: most have no flag, and are passed by eight at a
// time.
template <class Found>
void for_flagged(const std::uint8_t* flags, std::size_t n, const Found& found) {
  for (std::size_t i = 0; i < n; i += sizeof(std::uint64_t)) {
    std::uint64_t eight = 0;  // kRun and the scratch are whole eights
    std::memcpy(&eight, flags + i, sizeof eight);
    if (eight == 0) continue;
    for (std::size_t k = i; k < std::min(i + sizeof eight, n); ++k) {
      if (flags[k] != 0) found(k);
    }
  }
}

// A run of pairs on its way: values and densities of all parts, then the whole mixture's.
template <class In, class Out>
class Run {
 public:
  Run(const Sampler& sampler, Isa isa, std::size_t padded, Scratch<In, Out>& scratch)
      : material_(sampler.material().impl()),
        sampler_(sampler.impl()),
        isa_(isa),
        sampling_(sampling_kernels(isa)),
        padded_(padded),
        scratch_(scratch) {
    std::fill_n(scratch_.flags, padded, std::uint8_t{0});
  }

  [[nodiscard]] bool is_mixture() const { return sampler_.strategies() > 1; }

  // Values in scratch.values, channel by channel, `padded` apart, and pdfs; with `weigh` the values
  // become weights.
  void evaluate(const KernelInput<In>& in, bool weigh) {
    KernelOutput<Out> out{scratch_.values, padded_, scratch_.flags, false};
    DensityOutput<Out> density{scratch_.pdf, nullptr, false};
    std::size_t lobe = 0;
    for (const MaterialPart& part : material_.parts) {
      if (draws(part, sampler_)) {
        density.share = is_mixture() ? scratch_.shares[lobe] : nullptr;
        evaluate_part(part, sampler_, isa_, in, out, density);
        density.accumulate = true;
        ++lobe;
      } else {
        kernel_of(part.kernels(kernels(isa_)), In(), Out())(part.constants.get(), in, out);
      }
      out.accumulate = true;
    }
    const FinishRun<In, Out> finish{{in.wo[0], in.wo[1], in.wo[2]},
                                    padded_,
                                    scratch_.pdf,
                                    sampler_.cosine,
                                    sampler_.lobes > 0,
                                    is_mixture() ? scratch_.shares[sampler_.lobes] : nullptr,
                                    scratch_.values,
                                    padded_,
                                    weigh ? material_.channels : 0};
    finish_of(sampling_, In(), Out())(finish);
  }

  // The shares of the strategies, if there are several; `xi` and `chosen` may be null.
  void share(const In* const (&wi)[3], In* xi, In* chosen) {
    if (!is_mixture()) return;
    if constexpr (std::is_same_v<In, Out>) {
      ShareRun<Out> run{{wi[0], wi[1], wi[2]}, padded_, {}, xi, chosen};
      for (std::size_t k = 0; k < kMaxStrategies; ++k) run.shares[k] = scratch_.shares[k];
      share_of(sampling_, Out())(sampler_.table, run);
    } else {
      alignas(kAlignment) Out wide[3][kRun];
      for (int c = 0; c < 3; ++c) std::copy_n(wi[c], padded_, wide[c]);
      ShareRun<Out> run{{wide[0], wide[1], wide[2]}, padded_, {}, nullptr, nullptr};
      for (std::size_t k = 0; k < kMaxStrategies; ++k) run.shares[k] = scratch_.shares[k];
      share_of(sampling_, Out())(sampler_.table, run);
    }
  }

  void draw(DrawRun<In> run) {
    if (!is_mixture()) run.chosen = nullptr;
    for (const MaterialPart& part : material_.parts) {
      if (!draws(part, sampler_)) continue;
      draw_part(part, sampler_, sampling_, run);
      ++run.strategy;
    }
    if (sampler_.cosine) cosine_of(sampling_, In())(nullptr, run);
  }

  // What is flagged has no density.
  std::uint8_t clear_flagged(std::size_t n) {
    std::uint8_t any = 0;
    for_flagged(scratch_.flags, n, [&](std::size_t i) {
      any = static_cast<std::uint8_t>(any | scratch_.flags[i]);
      scratch_.pdf[i] = 0;
      for (int c = 0; c < material_.channels; ++c)
        scratch_.values[static_cast<std::size_t>(c) * padded_ + i] = 0;
    });
    return any;
  }

 private:
  const Material::Impl& material_;
  const Sampler::Impl& sampler_;
  Isa isa_;
  const SamplingTable& sampling_;
  std::size_t padded_;
  Scratch<In, Out>& scratch_;
};

std::size_t run_length(const Sampler& sampler) {
  const auto channels = static_cast<std::size_t>(sampler.material().channels());
  return std::min(kRun, kScratchValues / channels / kGrain * kGrain);
}

template <class In, class Out>
std::uint8_t evaluate_all(const Sampler& sampler, const Batch<In, Out>& batch, Out* pdf, Isa isa) {
  assert(is_supported(isa));
  const FlushToZero flush;
  const KernelTable& table = kernels(isa);
  Scratch<In, Out> scratch;
  std::uint8_t any = 0;
  for (std::size_t begin = 0, n = 0; begin < batch.count; begin += n) {
    n = std::min(run_length(sampler), batch.count - begin);
    const std::size_t padded = padded_to(table, n);
    Run<In, Out> run(sampler, isa, padded, scratch);
    KernelInput<In> in{{}, {}, padded};
    lay_out(advanced(batch.wi, begin), n, padded, table, scratch.wi, in.wi);
    lay_out(advanced(batch.wo, begin), n, padded, table, scratch.wo, in.wo);
    run.share(in.wi, nullptr, nullptr);
    run.evaluate(in, false);
    any = static_cast<std::uint8_t>(any | run.clear_flagged(n));
    copy_values(scratch.values, padded, sampler.material().channels(), n, table, batch.values,
                begin);
    std::copy_n(scratch.pdf, n, pdf + begin);
    if (batch.flags != nullptr) std::copy_n(scratch.flags, n, batch.flags + begin);
  }
  return any;
}

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
std::uint8_t evaluate(const Sampler& s, const Batch<float, float>& b, float* pdf, Isa isa) {
  return evaluate_all(s, b, pdf, isa);
}
std::uint8_t evaluate(const Sampler& s, const Batch<float, double>& b, double* pdf, Isa isa) {
  return evaluate_all(s, b, pdf, isa);
}
std::uint8_t evaluate(const Sampler& s, const Batch<double, double>& b, double* pdf, Isa isa) {
  return evaluate_all(s, b, pdf, isa);
}

}  // namespace gonio
