#include "engine/truth/truth.h"

#include <algorithm>

#include "engine/material/material_impl.h"
#include "numeric/extended.h"
#include "parts/geometry.h"

namespace gonio {
namespace {

PartTruth truth_of(const Part& part) { return part.kind->truth(part); }

// A part with one of its numbers, in all channels, times `factor`.
Part scaled(const Part& part, std::string_view name, double factor) {
  auto lobe = std::make_shared<CheckedLobe>(*part.lobe);
  std::vector<double> numbers = lobe->values.all().find(name)->second;
  for (double& number : numbers) number *= factor;
  lobe->values.set(name, std::move(numbers));
  return {part.kind, part.made, std::move(lobe), part.channels};
}

}  // namespace

Truth::Truth(const Material& material) : channels_(material.channels()) {
  for (const Part& part : material.impl().parts) parts_.push_back(truth_of(part));
}

std::vector<Truth> Truth::of_roundings(const Material& material, double relative) {
  std::vector<Truth> all;
  const auto& parts = material.impl().parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const std::string_view name : parts[i].lobe->model->crossing) {
      for (const double factor : {1 - relative, 1 + relative}) {
        Truth moved(material);
        moved.parts_[i] = truth_of(scaled(parts[i], name, factor));
        all.push_back(std::move(moved));
      }
    }
  }
  return all;
}

void Truth::evaluate(const Direction& wi, const Direction& wo, std::span<long double> f,
                     std::span<long double> scale) const {
  std::ranges::fill(f, 0.0L);
  std::ranges::fill(scale, 0.0L);
  const Vec3<LongDouble> i{wi[0], wi[1], wi[2]}, o{wo[0], wo[1], wo[2]};
  const Geometry<Extended> pair(i, o, i, o);
  if (!pair.valid) return;
  for (const PartTruth& part : parts_) part.add(part.data.get(), pair, f, scale);
}

}  // namespace gonio
