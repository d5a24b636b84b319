// A run of pairs, or of samples, on its way through the kernels: what sample.cpp and
// evaluate_pdf.cpp share.
#pragma once

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "engine/material/layout.h"
#include "engine/sampling/strategies.h"

namespace gonio::sampling {

inline constexpr std::size_t kAlignment = 64;
inline constexpr std::size_t kMaxStrategies = MixtureTable::kMaxLobes + 1;
inline constexpr std::size_t kScratchValues =
    8192;  // pairs x channels; at least kGrain of the most
// Samples in a run, at most. The memory of the next run comes while one is computed: the sooner
// that is over, the less is waited for, where a batch is more than the second-level cache holds.
inline constexpr std::size_t kCachedRun = 128, kUncachedRun = 64, kCachedBatch = 16'384;

template <class In, class Out>
struct Scratch {
  alignas(kAlignment) In wi[3][kRun];
  alignas(kAlignment) In wo[3][kRun];
  alignas(kAlignment) Out shares[kMaxStrategies][kRun];
  alignas(kAlignment) Out pdf[kRun];
  alignas(kAlignment) Out values[kScratchValues];
  alignas(kAlignment) std::uint8_t flags[kRun];
};

// Draws take two packets at a time.
inline std::size_t padded_to(const KernelTable& table, std::size_t n) {
  const auto width = 2 * static_cast<std::size_t>(table.width);
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
        scratch_(scratch) {}

  [[nodiscard]] bool is_mixture() const { return sampler_.strategies() > 1; }

  // Values in scratch.values, channel by channel, `padded` apart, pdfs and flags.
  void evaluate(const KernelInput<In>& in) {
    std::fill_n(scratch_.flags, padded_, std::uint8_t{0});
    lobes(in, scratch_.flags, true);
    finish(in, 0, nullptr);
  }

  // The same for pairs that have been drawn, the first `n` of which are samples: values become
  // weights, and lost samples get their flag. Where a measured table knows nothing they are lost,
  // too, and not counted yet.
  Finished weigh(const KernelInput<In>& in, std::size_t n) {
    if (!sampler_.has_gaps) {
      lobes(in, nullptr, false);
      return finish(in, n, scratch_.flags);
    }
    alignas(kAlignment) std::uint8_t told[kRun];
    std::fill_n(told, padded_, std::uint8_t{0});
    lobes(in, told, false);
    const Finished finished = finish(in, n, scratch_.flags);
    for_flagged(told, n, [&](std::size_t i) {
      if (told[i] != flag::outside_data) return;
      scratch_.flags[i] = flag::outside_data;
      clear(i);
    });
    return finished;
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
    for (std::size_t i = 0; i < material_.parts.size(); ++i) {
      const Strategy part = strategy(material_, sampler_, i);
      if (!part.draws()) continue;
      part.draw(isa_, run);
      ++run.strategy;
    }
    if (sampler_.cosine) cosine_of(sampling_, In())(nullptr, run);
  }

  // What is flagged has no density.
  void clear(std::size_t i) {
    scratch_.pdf[i] = 0;
    for (int c = 0; c < material_.channels; ++c)
      scratch_.values[static_cast<std::size_t>(c) * padded_ + i] = 0;
  }

 private:
  void lobes(const KernelInput<In>& in, std::uint8_t* flags, bool tell_holes) {
    KernelOutput<Out> out{scratch_.values, padded_, flags, false, tell_holes};
    DensityOutput<Out> density{scratch_.pdf, nullptr, false};
    std::size_t lobe = 0;
    for (std::size_t i = 0; i < material_.parts.size(); ++i) {
      const Strategy part = strategy(material_, sampler_, i);
      density.share = is_mixture() ? scratch_.shares[lobe] : nullptr;
      part.evaluate(isa_, in, out, density);
      if (part.draws()) {
        density.accumulate = true;
        ++lobe;
      }
      out.accumulate = true;
    }
  }

  Finished finish(const KernelInput<In>& in, std::size_t samples, std::uint8_t* flags) {
    return finish_of(sampling_, In(),
                     Out())({{in.wi[0], in.wi[1], in.wi[2]},
                             {in.wo[0], in.wo[1], in.wo[2]},
                             padded_,
                             samples,
                             scratch_.pdf,
                             sampler_.cosine,
                             sampler_.lobes > 0,
                             is_mixture() ? scratch_.shares[sampler_.lobes] : nullptr,
                             scratch_.values,
                             padded_,
                             material_.channels,
                             flags});
  }

  const Material::Impl& material_;
  const Sampler::Impl& sampler_;
  Isa isa_;
  const SamplingTable& sampling_;
  std::size_t padded_;
  Scratch<In, Out>& scratch_;
};

// For a batch of `count`.
inline std::size_t run_length(const Sampler& sampler, std::size_t count) {
  const auto channels = static_cast<std::size_t>(sampler.material().channels());
  const std::size_t run = count > kCachedBatch ? kUncachedRun : kCachedRun;
  return std::min(run, kScratchValues / channels / kGrain * kGrain);
}

}  // namespace gonio::sampling
