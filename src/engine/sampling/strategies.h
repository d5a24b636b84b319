// How the parts of a material are drawn and evaluated with their densities: each by its own
// kernels, what has none by the cosine.
#pragma once

#include "engine/sampling/sampler_impl.h"

namespace gonio {

// A part of a material beside what it draws from.
struct Strategy {
  const Part& part;
  const void* drawn;  // null for what draws no lobe of its own

  [[nodiscard]] bool draws() const { return drawn != nullptr; }

  // Of a part that draws().
  template <class T>
  void draw(Isa isa, const DrawRun<T>& run) const {
    draw_of(part.kind->kernels(isa).sampling, T())(drawn, run);
  }

  // Values, and of a part that draws() also densities.
  template <class In, class Out>
  void evaluate(Isa isa, const KernelInput<In>& in, const KernelOutput<Out>& out,
                const DensityOutput<Out>& density) const {
    const PartKernels& kernels = part.kind->kernels(isa);
    if (draws()) {
      density_of(kernels.sampling, In(), Out())(drawn, in, out, density);
    } else {
      kernel_of(kernels.eval, In(), Out())(part.made.data.get(), in, out);
    }
  }
};

inline Strategy strategy(const Material::Impl& material, const Sampler::Impl& sampler,
                         std::size_t i) {
  return {material.parts[i], sampler.drawn[i].data.get()};
}

}  // namespace gonio
