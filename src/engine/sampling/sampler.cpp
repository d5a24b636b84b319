#include "gonio/engine/sampler.h"

#include <algorithm>

#include "engine/material/mixture.h"
#include "engine/sampling/strategies.h"

namespace gonio {
namespace {

// Of linear red, green and blue (ITU-R BT.709).
void luminance_of(const Material& material, std::span<const PartDirection> wi,
                  std::span<const PartDirection> wo, std::span<double> luminance) {
  constexpr std::array kWeights{0.2126, 0.7152, 0.0722};
  std::vector<double> rgb(3 * wi.size());
  evaluate(material,
           Batch<double, double>{Directions<double>::interleaved(wi.data()->data()),
                                 Directions<double>::interleaved(wo.data()->data()), wi.size(),
                                 Values<double>::interleaved(rgb.data(), 3), nullptr},
           Isa::baseline);
  for (std::size_t i = 0; i < wi.size(); ++i) {
    luminance[i] = 0;
    for (std::size_t c = 0; c < kWeights.size(); ++c) luminance[i] += kWeights[c] * rgb[3 * i + c];
  }
}

// What a part draws from; nothing for one that does not draw.
PartData prepare_sampling(const Part& part) {
  if (!part.kind->draws()) return {};
  if (part.kind->prepare_sampling == nullptr) return {part.made.data, 0};
  auto alone = std::make_shared<Material::Impl>();
  alone->channels = part.channels;
  alone->add(part);
  const Material material(std::move(alone));
  return part.kind->prepare_sampling(
      part, [&](auto wi, auto wo, auto luminance) { luminance_of(material, wi, wo, luminance); });
}

}  // namespace

Sampler Sampler::create(const Material& material) {
  auto impl = std::make_shared<Impl>();
  const Material::Impl& whole = material.impl();
  for (const Part& part : whole.parts) {
    impl->drawn.push_back(prepare_sampling(part));
    if (part.kind->draws()) ++impl->lobes;
    impl->has_gaps = impl->has_gaps || part.kind->has_gaps;
  }
  impl->cosine = true;
  if (impl->lobes > 0) tabulate_shares(whole, *impl);
  return {material, std::move(impl)};
}

std::size_t Sampler::bytes() const {
  std::size_t bytes = sizeof(Impl);
  for (const PartData& drawn : impl_->drawn) bytes += drawn.bytes;
  return bytes;
}

}  // namespace gonio
