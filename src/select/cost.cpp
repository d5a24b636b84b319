#include "select/cost.h"

#include <algorithm>
#include <chrono>
#include <random>

#include "engine/evaluate.h"
#include "engine/sampler.h"

namespace gonio::select {
namespace {

constexpr int kRepeats = 15;
constexpr std::size_t kIncident = 64, kSamples = 256;  // of the second moment

template <class Out>
double best_ns(const Material& material, const fit::Data& data) {
  const std::size_t count = std::min(kTilePairs, data.size());
  std::vector<Out> values(count * static_cast<std::size_t>(material.channels()));
  const Batch<float, Out> batch{data.incident(0), data.outgoing(0), count,
                                Values<Out>::planar(values.data(), count), nullptr};
  double best = 1e300;
  for (int i = 0; i < kRepeats; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    evaluate(material, batch, best_isa());
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    best = std::min(best, took.count() / static_cast<double>(count));
  }
  return best;
}

}  // namespace

Result<double> ns_from(const CostTable& table, const std::vector<std::string>& parts) {
  double sum = 0;
  for (const std::string& part : parts) {
    const auto found = table.find(part);
    if (found == table.end())
      return bad_value("options.costs", "without \"" + part + "\"", "a number for every part");
    if (!(found->second > 0))
      return bad_value("options.costs." + part, std::to_string(found->second), "above 0");
    sum += found->second;
  }
  return sum;
}

double measured_ns(const Material& material, const fit::Data& data, Precision precision) {
  return precision == Precision::fast ? best_ns<float>(material, data)
                                      : best_ns<double>(material, data);
}

double relative_second_moment(const Material& material, const Distribution& scene,
                              std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<float> wi;
  for (std::size_t i = 0; i < kIncident; ++i) {
    for (const double x : scene.draw(random).wi) wi.push_back(static_cast<float>(x));
  }
  const std::size_t count = kIncident * kSamples;
  const auto channels = static_cast<std::size_t>(material.channels());
  std::vector<float> wo(3 * count), pdf(count), weights(count * channels);
  SampleBatch<float> batch;
  batch.wi = Directions<float>::interleaved(wi.data());
  batch.count = count;
  batch.per_wi = kSamples;
  batch.numbers = {Sequence::random, seed};
  batch.wo = wo.data();
  batch.pdf = pdf.data();
  batch.weights = Values<float>::planar(weights.data(), count);
  sample(Sampler::create(material), batch, best_isa());
  double squares = 0, means = 0;
  for (std::size_t i = 0; i < kIncident; ++i) {
    double sum = 0, square = 0;
    for (std::size_t s = i * kSamples; s < (i + 1) * kSamples; ++s) {
      double weight = 0;
      for (std::size_t c = 0; c < channels; ++c)
        weight += static_cast<double>(weights[c * count + s]);
      sum += weight / kSamples;
      square += weight * weight / kSamples;
    }
    squares += square;
    means += sum * sum;
  }
  return means > 0 ? squares / means : 1;
}

}  // namespace gonio::select
