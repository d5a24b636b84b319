#include "models/sampling/sampling_subject.h"

#include <cmath>

#include "engine/sampling/sampler_impl.h"
#include "models/oracle/run.h"

namespace gonio::testing {
namespace {

template <class T>
Samples<T> draw(const Sampler& sampler, Isa isa, const Direction& wi, const std::vector<T>& xi) {
  const std::size_t count = xi.size() / 3;
  const int channels = sampler.material().channels();
  // What is not written shows as improper.
  Samples<T> s{std::vector<T>(xi.size(), T(-1)), std::vector<T>(count, T(-1)),
               std::vector<T>(count * static_cast<std::size_t>(channels), T(-1)),
               std::vector<std::uint8_t>(count, 255)};
  const std::array<T, 3> given{static_cast<T>(wi[0]), static_cast<T>(wi[1]), static_cast<T>(wi[2])};
  SampleBatch<T> batch{.wi = Directions<T>::interleaved(given.data()),
                       .count = count,
                       .per_wi = count,
                       .xi = xi.data(),
                       .numbers = {},
                       .wo = s.wo.data(),
                       .pdf = s.pdf.data(),
                       .weights = Values<T>::interleaved(s.weights.data(), channels),
                       .flags = s.flags.data()};
  s.lost = sample(sampler, batch, isa).lost;
  return s;
}

template <class T>
Densities<T> densities(const Sampler& sampler, Isa isa, const Direction& wi,
                       const std::vector<T>& wo) {
  const std::size_t count = wo.size() / 3;
  const int channels = sampler.material().channels();
  Densities<T> d{std::vector<T>(count, T(-1)),
                 std::vector<T>(count * static_cast<std::size_t>(channels), T(-1))};
  const std::array<T, 3> given{static_cast<T>(wi[0]), static_cast<T>(wi[1]), static_cast<T>(wi[2])};
  Directions<T> repeated = Directions<T>::interleaved(given.data());
  repeated.stride = 0;
  evaluate(sampler,
           Batch<T, T>{repeated, Directions<T>::interleaved(wo.data()), count,
                       Values<T>::interleaved(d.f.data(), channels), nullptr},
           d.pdf.data(), isa);
  return d;
}

}  // namespace

template <class T>
SamplingSubject<T> library_sampling(const MaterialSpec& spec, const Sampler& sampler, Isa isa) {
  return {spec, sampler, static_cast<std::size_t>(sampler.material().channels()),
          [=](const Direction& wi, const std::vector<T>& xi) { return draw(sampler, isa, wi, xi); },
          [=](const Direction& wi, const std::vector<T>& wo) {
            return densities(sampler, isa, wi, wo);
          }};
}
template SamplingSubject<float> library_sampling(const MaterialSpec&, const Sampler&, Isa);
template SamplingSubject<double> library_sampling(const MaterialSpec&, const Sampler&, Isa);

Sampler sampler_of(const MaterialSpec& spec) { return Sampler::create(material_of(spec)); }

std::vector<double> shares_of(const Sampler& sampler, double cos_i) {
  const Sampler::Impl& impl = sampler.impl();
  if (impl.strategies() == 1) return {1};
  constexpr int kNodes = MixtureTable::kNodes;
  const double at = std::sqrt(cos_i) * (kNodes - 1);
  const int node = std::min(static_cast<int>(at), kNodes - 2);
  std::vector<double> shares;
  double rest = 1;
  for (int k = 0; k < impl.table.given; ++k) {
    const float* values = impl.table.values + k * kNodes + node;
    shares.push_back(
        std::lerp(static_cast<double>(values[0]), static_cast<double>(values[1]), at - node));
    rest -= shares.back();
  }
  shares.push_back(rest);
  return shares;
}

template <class T>
std::vector<T> numbers(std::uint64_t seed, std::size_t count) {
  std::vector<T> separate(3 * count), xi;
  random_numbers({Sequence::random, seed}, 0, 1, count,
                 {separate.data(), separate.data() + count, separate.data() + 2 * count});
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) xi.push_back(separate[k * count + i]);
  }
  return xi;
}
template std::vector<float> numbers(std::uint64_t, std::size_t);
template std::vector<double> numbers(std::uint64_t, std::size_t);

}  // namespace gonio::testing
