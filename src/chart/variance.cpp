#include "chart/variance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/direction.h"

namespace gonio::chart {
namespace {

Variance moments_of(const std::vector<double>& weights, int channels, double lost) {
  const auto count = static_cast<std::size_t>(channels);
  const std::size_t n = weights.size() / count;
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double weight = 0;
    for (std::size_t c = 0; c < count; ++c) weight += weights[i * count + c];
    weight /= channels;
    sum += weight, squares += weight * weight;
  }
  const double mean = sum / static_cast<double>(n);
  return {squares / static_cast<double>(n) - mean * mean, mean, lost / static_cast<double>(n)};
}

// f of one wi and many wo.
std::vector<double> values_of(const Material& material, const Vector64& wi,
                              const std::vector<double>& wo) {
  const std::size_t n = wo.size() / 3;
  std::vector<double> wis(3 * n), values(n * static_cast<std::size_t>(material.channels()));
  for (std::size_t i = 0; i < wis.size(); ++i) wis[i] = wi[i % 3];
  evaluate(material,
           Batch<double, double>{Directions<double>::interleaved(wis.data()),
                                 Directions<double>::interleaved(wo.data()), n,
                                 Values<double>::interleaved(values.data(), material.channels()),
                                 nullptr},
           best_isa());
  return values;
}

}  // namespace

Vector64 direction(double theta_degrees, double azimuth_degrees) {
  const double t = theta_degrees * std::numbers::pi / 180,
               p = azimuth_degrees * std::numbers::pi / 180;
  return spherical(t, p);
}

Variance own_variance(const Material& material, const Vector64& wi, const VarianceEffort& effort) {
  const Sampler sampler = Sampler::create(material);
  std::vector<double> wo(3 * effort.points), pdf(effort.points);
  std::vector<double> weights(effort.points * static_cast<std::size_t>(material.channels()));
  SampleBatch<double> batch;
  batch.wi = Directions<double>::interleaved(wi.data());
  batch.count = batch.per_wi = effort.points;
  batch.numbers = {Sequence::sobol, effort.seed};
  batch.wo = wo.data();
  batch.pdf = pdf.data();
  batch.weights = Values<double>::interleaved(weights.data(), material.channels());
  const SampleReport report = sample(sampler, batch, best_isa());
  return moments_of(weights, material.channels(), static_cast<double>(report.lost));
}

Variance variance_of(const DrawFunction& draw, const PdfFunction& density, const Material& material,
                     const Vector64& wi, const VarianceEffort& effort) {
  std::vector<double> u[3], wo(3 * effort.points), factor(effort.points);
  for (auto& x : u) x.resize(effort.points);
  random_numbers({Sequence::sobol, effort.seed}, 0, effort.points, effort.points,
                 {u[0].data(), u[1].data(), u[2].data()});
  double lost = 0;
  for (std::size_t i = 0; i < effort.points; ++i) {
    const Vector64 out = draw(wi, {u[0][i], u[1][i], u[2][i]});
    std::copy(out.begin(), out.end(), wo.begin() + static_cast<std::ptrdiff_t>(3 * i));
    const double pdf = density(wi, out);
    lost += out[2] > 0 ? 0 : 1;
    factor[i] = pdf > 0 ? std::max(out[2], 0.0) / pdf : 0;
  }
  std::vector<double> weights = values_of(material, wi, wo);
  const auto channels = static_cast<std::size_t>(material.channels());
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] *= factor[i / channels];
  return moments_of(weights, material.channels(), lost);
}

}  // namespace gonio::chart
