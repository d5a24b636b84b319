#include "gonio/engine/sampler.h"

#include <algorithm>

#include "engine/material/mixture.h"
#include "engine/sampling/strategies.h"

namespace gonio {
namespace {

using Direction = TableSampling::Direction;

// Of linear red, green and blue (ITU-R BT.709).
void luminance_of(const Material& material, std::span<const Direction> wi,
                  std::span<const Direction> wo, std::span<double> luminance) {
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

}  // namespace

Sampler Sampler::create(const Material& material) {
  auto impl = std::make_shared<Impl>();
  const auto& parts = material.impl().parts;
  const auto source = parts.front().source;
  if (source == MaterialPart::Source::measured_linear ||
      source == MaterialPart::Source::measured_nearest) {
    impl->measured = std::make_unique<const TableSampling>(
        [&](auto wi, auto wo, auto luminance) { luminance_of(material, wi, wo, luminance); });
  }
  impl->lobes = static_cast<int>(std::count_if(
      parts.begin(), parts.end(), [&](const auto& part) { return draws(part, *impl); }));
  impl->cosine = true;
  if (impl->lobes > 0) tabulate_shares(material.impl(), *impl);
  return {material, std::move(impl)};
}

std::size_t Sampler::bytes() const {
  return sizeof(Impl) + (impl_->measured != nullptr ? impl_->measured->bytes() : 0);
}

}  // namespace gonio
