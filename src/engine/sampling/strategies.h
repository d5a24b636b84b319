// How the parts of a material are drawn and evaluated with their densities: analytic lobes by the
// kernels of their kind, a measured table by its own cells, all else by the cosine.
#pragma once

#include "engine/sampling/sampler_impl.h"

namespace gonio {

// Null for what draws no lobe of its own.
inline const SamplingKernels* sampling_of(const MaterialPart& part, const SamplingTable& table) {
  if (part.source != MaterialPart::Source::analytic) return nullptr;
  const SamplingKernels& kernels = table.analytic[part.kernel];
  return kernels.fast != nullptr ? &kernels : nullptr;
}

// Whether the part is a strategy of its own.
inline bool draws(const MaterialPart& part, const Sampler::Impl& sampler) {
  return sampler.measured != nullptr ||
         sampling_of(part, sampling_kernels(Isa::baseline)) != nullptr;
}

template <class T>
void draw_measured(const TableSampling& table, const DrawRun<T>& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    if (run.chosen != nullptr && run.chosen[i] != static_cast<T>(run.strategy)) continue;
    const TableSampling::Direction wo = table.draw({run.wi[0][i], run.wi[1][i], run.wi[2][i]},
                                                   run.xi[0][i], run.xi[1][i], run.xi[2][i]);
    for (std::size_t c = 0; c < 3; ++c) run.wo[c][i] = static_cast<T>(wo[c]);
  }
}

template <class In, class Out>
void add_measured_density(const TableSampling& table, const KernelInput<In>& in,
                          const DensityOutput<Out>& out) {
  for (std::size_t i = 0; i < in.count; ++i) {
    const auto density = static_cast<Out>(table.density({in.wi[0][i], in.wi[1][i], in.wi[2][i]},
                                                        {in.wo[0][i], in.wo[1][i], in.wo[2][i]}));
    const Out part = out.share != nullptr ? density * out.share[i] : density;
    out.pdf[i] = out.accumulate ? out.pdf[i] + part : part;
  }
}

// Of a part that draws().
template <class T>
void draw_part(const MaterialPart& part, const Sampler::Impl& sampler, const SamplingTable& table,
               const DrawRun<T>& run) {
  if (sampler.measured != nullptr) {
    draw_measured(*sampler.measured, run);
  } else {
    draw_of(*sampling_of(part, table), T())(part.constants.get(), run);
  }
}

// Of a part that draws(): its values, and its densities.
template <class In, class Out>
void evaluate_part(const MaterialPart& part, const Sampler::Impl& sampler, Isa isa,
                   const KernelInput<In>& in, const KernelOutput<Out>& out,
                   const DensityOutput<Out>& density) {
  if (sampler.measured != nullptr) {
    kernel_of(part.kernels(kernels(isa)), In(), Out())(part.constants.get(), in, out);
    add_measured_density(*sampler.measured, in, density);
  } else {
    const SamplingKernels& own = *sampling_of(part, sampling_kernels(isa));
    density_of(own, In(), Out())(part.constants.get(), in, out, density);
  }
}

}  // namespace gonio
