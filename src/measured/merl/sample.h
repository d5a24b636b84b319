// Samples of a measured table and their densities (sampling.h), one after the other.
#pragma once

#include "measured/merl/eval.h"

namespace gonio::GONIO_ISA {

template <class T>
void draw_from_table(const void* data, const DrawRun<T>& run) {
  const TableSampling& table = *static_cast<const merl::Drawn*>(data)->sampling;
  for (std::size_t i = 0; i < run.count; ++i) {
    if (run.chosen != nullptr && run.chosen[i] != static_cast<T>(run.strategy)) continue;
    const double wi[3] = {run.wi[0][i], run.wi[1][i], run.wi[2][i]};
    const double xi[3] = {run.xi[0][i], run.xi[1][i], run.xi[2][i]};
    double wo[3];
    merl::draw(table, wi, xi, wo);
    for (int c = 0; c < 3; ++c) run.wo[c][i] = static_cast<T>(wo[c]);
  }
}

template <class N, bool kLinear, class In>
void look_up_with_density(const void* data, const KernelInput<In>& in,
                          const KernelOutput<typename N::Out>& out,
                          const DensityOutput<typename N::Out>& density) {
  using Out = typename N::Out;
  const auto& drawn = *static_cast<const merl::Drawn*>(data);
  look_up<N, kLinear>(&drawn.constants, in, out);
  for (std::size_t i = 0; i < in.count; ++i) {
    const double wi[3] = {in.wi[0][i], in.wi[1][i], in.wi[2][i]};
    const double wo[3] = {in.wo[0][i], in.wo[1][i], in.wo[2][i]};
    const auto own = static_cast<Out>(merl::density(*drawn.sampling, wi, wo));
    const Out part = density.share != nullptr ? own * density.share[i] : own;
    density.pdf[i] = density.accumulate ? density.pdf[i] + part : part;
  }
}

}  // namespace gonio::GONIO_ISA
