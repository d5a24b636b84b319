#include "engine/sampler.h"

#include <algorithm>

#include "engine/mixture.h"
#include "engine/sampler_impl.h"

namespace gonio {

Sampler Sampler::create(const Material& material) {
  auto impl = std::make_shared<Impl>();
  const SamplingTable& table = sampling_kernels(Isa::baseline);
  const auto& parts = material.impl().parts;
  impl->lobes = static_cast<int>(std::count_if(parts.begin(), parts.end(), [&](const auto& part) {
    return sampling_of(part, table) != nullptr;
  }));
  impl->cosine = true;
  if (impl->lobes > 0) tabulate_shares(material.impl(), *impl);
  return {material, std::move(impl)};
}

std::size_t Sampler::bytes() const { return sizeof(Impl); }

}  // namespace gonio
