#include "assess/subject.h"

#include <numbers>

#include "engine/material/material_impl.h"

namespace gonio::assess {
namespace {

// The directions of pairs in a kernel's type, interleaved.
template <class In>
struct Given {
  std::vector<In> wi, wo;

  explicit Given(std::span<const Pair> pairs) {
    wi.reserve(3 * pairs.size());
    wo.reserve(3 * pairs.size());
    for (const Pair& pair : pairs) {
      for (const double x : pair.wi) wi.push_back(static_cast<In>(x));
      for (const double x : pair.wo) wo.push_back(static_cast<In>(x));
    }
  }
  template <class Out>
  Batch<In, Out> batch(std::vector<Out>& values, int channels) const {
    return {Directions<In>::interleaved(wi.data()), Directions<In>::interleaved(wo.data()),
            wi.size() / 3, Values<Out>::interleaved(values.data(), channels), nullptr};
  }
};

template <class T>
std::vector<double> values_of(const Material& material, std::span<const Pair> pairs, Isa isa) {
  const Given<T> given(pairs);
  std::vector<T> values(pairs.size() * static_cast<std::size_t>(material.channels()));
  evaluate(material, given.batch(values, material.channels()), isa);
  return {values.begin(), values.end()};
}

Subject::Densities densities_of(const Sampler& sampler, std::span<const Pair> pairs, Isa isa) {
  const Given<double> given(pairs);
  const int channels = sampler.material().channels();
  Subject::Densities result{std::vector<double>(pairs.size() * static_cast<std::size_t>(channels)),
                            std::vector<double>(pairs.size())};
  evaluate(sampler, given.batch(result.f, channels), result.pdf.data(), isa);
  return result;
}

template <class T>
Drawn draw(const Sampler& sampler, const std::array<double, 3>& wi, std::size_t count,
           const NumberSource& numbers, Isa isa) {
  const int channels = sampler.material().channels();
  const std::array<T, 3> given{static_cast<T>(wi[0]), static_cast<T>(wi[1]), static_cast<T>(wi[2])};
  std::vector<T> wo(3 * count), pdf(count), weights(count * static_cast<std::size_t>(channels));
  Drawn drawn;
  drawn.flags.resize(count);
  SampleBatch<T> batch;
  batch.wi = Directions<T>::interleaved(given.data());
  batch.count = batch.per_wi = count;
  batch.numbers = numbers;
  batch.wo = wo.data();
  batch.pdf = pdf.data();
  batch.weights = Values<T>::interleaved(weights.data(), channels);
  batch.flags = drawn.flags.data();
  drawn.lost = sample(sampler, batch, isa).lost;
  drawn.wo = {wo.begin(), wo.end()};
  drawn.pdf = {pdf.begin(), pdf.end()};
  drawn.weights = {weights.begin(), weights.end()};
  return drawn;
}

std::vector<double> rarer_than_outside(const Material& material) {
  std::vector<double> indices;
  for (const Part& part : material.impl().parts) {
    if (find_used(*part.lobe, Quantity::extinction) != nullptr) continue;
    const Parameter* index = find_used(*part.lobe, Quantity::refractive_index);
    if (index == nullptr) continue;
    for (const double eta : part.lobe->values.all().find(index->name)->second) {
      if (eta < 1) indices.push_back(eta);
    }
  }
  return indices;
}

}  // namespace

Subject subject_of(const Sampler& sampler, Isa isa) {
  const Material& material = sampler.material();
  return {
      .channels = material.channels(),
      .fast = material.error_bound(Precision::fast),
      .reference = material.error_bound(Precision::reference),
      .evaluate =
          [material, isa](std::span<const Pair> pairs, Precision precision) {
            return precision == Precision::fast ? values_of<float>(material, pairs, isa)
                                                : values_of<double>(material, pairs, isa);
          },
      .densities = [sampler,
                    isa](std::span<const Pair> pairs) { return densities_of(sampler, pairs, isa); },
      .draw =
          [sampler, isa](const std::array<double, 3>& wi, std::size_t count,
                         const NumberSource& numbers, Precision precision) {
            return precision == Precision::fast ? draw<float>(sampler, wi, count, numbers, isa)
                                                : draw<double>(sampler, wi, count, numbers, isa);
          },
      .tangents = material.impl().rotation * (std::numbers::pi / 180),
      .rarer = rarer_than_outside(material),
      .table = table_of(material),
      .truth = Truth(material),
      .roundings = Truth::of_roundings(material, kStep),
      .naive32 = NaiveMaterial<float>::of(material),
      .naive64 = NaiveMaterial<double>::of(material)};
}

}  // namespace gonio::assess
