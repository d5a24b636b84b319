// Measured data made from a known material.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "fit/data/data.h"
#include "fit/fit.h"
#include "fit/report/metrics.h"
#include "gonio/engine/evaluate.h"

namespace gonio::testing {

struct Pairs {
  std::vector<double> wi, wo, weights;
};

// Pairs as a gonioreflectometer takes them: half about the mirror direction at all scales, half
// over the hemisphere, up to 80 degrees. Weights are 1 over the density. `least`: the smallest
// angle from the mirror direction, in radians.
inline Pairs scattered_pairs(std::size_t count, unsigned seed, double least = 1e-3) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  const double lowest = std::cos(fit::kGrazing);
  Pairs pairs;
  while (pairs.weights.size() < count) {
    const double zi = lowest + (1 - lowest) * uniform(random);
    const double si = std::sqrt(1 - zi * zi), turn = 2 * std::numbers::pi * uniform(random);
    const double phi = 2 * std::numbers::pi * uniform(random);
    // The angle from the mirror direction, its logarithm even up to pi.
    const double ratio = std::numbers::pi / least;
    const double angle = least * std::pow(ratio, uniform(random));
    const double x = std::sin(angle) * std::cos(turn), y = std::sin(angle) * std::sin(turn),
                 z = std::cos(angle);
    const double up = zi * z + si * x, along = zi * x - si * z;
    if (up < lowest) continue;
    const double c = std::cos(phi), s = std::sin(phi);
    pairs.wi.insert(pairs.wi.end(), {si * c, si * s, zi});
    pairs.wo.insert(pairs.wo.end(), {along * c - y * s, along * s + y * c, up});
    pairs.weights.push_back(std::sin(angle) * angle * std::log(ratio));
  }
  return pairs;
}

inline fit::Data data_of(const MaterialSpec& spec, const Pairs& pairs, double noise = 0,
                         unsigned seed = 1) {
  const auto material = Material::create(spec);
  EXPECT_TRUE(material.ok()) << (material ? "" : material.error().message);
  const auto channels = static_cast<std::size_t>(material->channels());
  const std::size_t n = pairs.weights.size();
  std::vector<double> values(n * channels);
  evaluate(*material,
           Batch<double, double>{Directions<double>::interleaved(pairs.wi.data()),
                                 Directions<double>::interleaved(pairs.wo.data()), n,
                                 Values<double>::interleaved(values.data(), material->channels()),
                                 nullptr},
           best_isa());
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; noise > 0 && i < n; ++i) {
    const double factor = std::exp(noise * normal(random));
    for (std::size_t c = 0; c < channels; ++c) values[i * channels + c] *= factor;
  }
  return *fit::from_pairs(pairs.wi, pairs.wo, values, material->channels(), pairs.weights);
}

// What is fitted: the material's models and words.
inline MaterialSpec form_of(const MaterialSpec& spec) {
  MaterialSpec form = spec;
  const auto strip = [](LobeSpec& lobe) {
    std::erase_if(lobe.parameters,
                  [](const auto& p) { return !std::holds_alternative<std::string>(p.second); });
  };
  if (form.model) strip(*form.model);
  if (form.diffuse) strip(*form.diffuse);
  for (LobeSpec& lobe : form.specular) strip(lobe);
  return form;
}

}  // namespace gonio::testing
