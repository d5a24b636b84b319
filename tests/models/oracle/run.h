// Evaluates test pairs with the library and with the oracle.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <stdexcept>
#include <vector>

#include "gonio/engine/evaluate.h"
#include "models/oracle/oracle.h"
#include "models/oracle/pairs.h"

namespace gonio::testing {

// What `run` writes for a batch of the pairs: pair by pair, channel by channel.
template <class Out, class In, class Run>
std::vector<Out> batch_values(int channels, const std::vector<DirectionPair<In>>& pairs,
                              const Run& run) {
  std::vector<In> wi, wo;
  for (const auto& pair : pairs) {
    wi.insert(wi.end(), pair.wi.begin(), pair.wi.end());
    wo.insert(wo.end(), pair.wo.begin(), pair.wo.end());
  }
  // A value that is not written shows as an improper one.
  std::vector<Out> values(pairs.size() * static_cast<std::size_t>(channels), Out(-1));
  run(Batch<In, Out>{Directions<In>::interleaved(wi.data()), Directions<In>::interleaved(wo.data()),
                     pairs.size(), Values<Out>::interleaved(values.data(), channels), nullptr});
  return values;
}

template <class Out, class In>
std::vector<Out> library_values(const Material& material,
                                const std::vector<DirectionPair<In>>& pairs, Isa isa) {
  return batch_values<Out>(material.channels(), pairs,
                           [&](const auto& batch) { evaluate(material, batch, isa); });
}

template <class Real, class In>
std::vector<Real> oracle_values(const Oracle<Real>& oracle,
                                const std::vector<DirectionPair<In>>& pairs) {
  std::vector<Real> values(pairs.size() * oracle.channels());
  const auto vec = [](const std::array<In, 3>& w) { return Vec<Real>{w[0], w[1], w[2]}; };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    oracle.evaluate(vec(pairs[i].wi), vec(pairs[i].wo),
                    std::span(values).subspan(i * oracle.channels(), oracle.channels()));
  }
  return values;
}

// The material of a specification that is known to be valid.
inline Material material_of(const MaterialSpec& spec) {
  auto material = Material::create(spec);
  if (!material) throw std::invalid_argument(material.error().message);
  return *material;
}

}  // namespace gonio::testing
