// What the registry knows of an analytic model, from its templates: kernels/model.cpp.in makes a
// file of it.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "kernels/constants.h"
#include "kernels/part.h"
#include "numeric/dual.h"
#include "numeric/extended.h"
#include "numeric/type_list.h"
#include "parts/degrees.h"
#include "parts/geometry.h"

namespace gonio {

template <class... Kinds>
constexpr std::size_t count_of(TypeList<Kinds...>) {
  return sizeof...(Kinds);
}

// How a material's tangents are turned, which its lobes' values say in degrees.
template <class S>
Tangents<S> tangents_of(const ParameterValues<S>& values) {
  const auto found = values.all().find(kRotation.name);
  if (found == values.all().end()) return {};
  const S degrees = found->second.front();
  return {rotation_by(degrees), is_turn(degrees)};
}

template <class Kind, class S>
PartData prepare_constants(const ParameterValues<S>& values, int channels) {
  using Made = Constants<Kind, S>;
  auto constants = std::make_shared<Made>();
  constants->shape = Kind::shape(values);
  constants->channels = channels;
  if constexpr (has_tangents<Kind>()) constants->tangents = tangents_of(values);
  for (int c = 0; c < channels; ++c) {
    constants->wide[c] = Kind::channel(values, c);
    if constexpr (Made::kForFloat)
      constants->real[c] = to_float<Kind::template Channel>(constants->wide[c]);
  }
  return {std::move(constants), sizeof(Made)};
}

template <class Kind>
PartData prepare_analytic(const CheckedLobe& lobe, int channels) {
  return prepare_constants<Kind>(lobe.values, channels);
}

template <class Kind>
PartData prepare_analytic_derivative(const CheckedLobe& lobe, int channels, std::string_view by) {
  ParameterValues<Dual<double>> seeded;
  for (const auto& [name, numbers] : lobe.values.all()) {
    std::vector<Dual<double>> duals;
    for (const double number : numbers) duals.emplace_back(number, name == by ? 1.0 : 0.0);
    seeded.set(name, std::move(duals));
  }
  return prepare_constants<Kind>(seeded, channels);
}

// The kernels' way through a model's steps, for one pair.
template <class Kind>
void add_truth(const void* constants, const Geometry<Extended>& pair, std::span<long double> f,
               std::span<long double> scale) {
  const auto& k = *static_cast<const Constants<Kind, LongDouble>*>(constants);
  Geometry<Extended> seen = pair;
  if constexpr (has_tangents<Kind>()) {
    if (k.tangents.turned) seen.turn(k.tangents.rotation);
  }
  const auto stage = Kind::template stage<Extended>(k.shape, seen);
  const auto refined = Kind::template refine<Extended>(k.shape, stage);
  const auto terms = Kind::template terms<Extended>(k.shape, stage, refined);
  for (std::size_t c = 0; c < f.size(); ++c) {
    const LongDouble value = Kind::template eval<Extended>(terms, k.wide[c], k.wide[c]);
    f[c] += min(Extended::largest(), value).v;
    if (!scale.empty()) scale[c] += min(Extended::largest(), value).v;
  }
}

template <class Kind>
PartTruth analytic_truth(const Part& part) {
  ParameterValues<LongDouble> extended;
  for (const auto& [name, numbers] : part.lobe->values.all())
    extended.set(name, {numbers.begin(), numbers.end()});
  return {prepare_constants<Kind>(extended, part.channels).data, &add_truth<Kind>};
}

// Kernels turn the directions of kinds that have_tangents(): of all kinds of a model that has them.
template <class Model, class... Kinds>
constexpr bool kernels_see_tangents(TypeList<Kinds...>) {
  return !Model::kDescription.has_tangents() || (has_tangents<Kinds>() && ...);
}

// The kinds of a model whose kernels are those of the arrays, in the order of its words.
template <class... Kinds>
constexpr std::array<PartKind, sizeof...(Kinds)> kinds_of(TypeList<Kinds...>,
                                                          const PartKernels* baseline,
                                                          const PartKernels* avx2,
                                                          const PartKernels* avx512) {
  std::array<PartKind, sizeof...(Kinds)> kinds{
      PartKind{.prepare = &prepare_analytic<Kinds>,
               .prepare_derivative = &prepare_analytic_derivative<Kinds>,
               .truth = &analytic_truth<Kinds>}...};
  for (std::size_t i = 0; i < kinds.size(); ++i)
    kinds[i].by_isa = {baseline + i, avx2 + i, avx512 + i};
  return kinds;
}

}  // namespace gonio
