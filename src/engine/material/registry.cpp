#include "gonio/engine/registry.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/near_names.h"
#include "engine/kernels/prepare.h"
#include "engine/material/degrees.h"
#include "models/all.h"
#include "numeric/dual.h"
#include "numeric/extended.h"

namespace gonio {
namespace {

constexpr std::array<std::string_view, 2> kInterpolations{"linear", "nearest"};
constexpr std::array kMeasuredParameters{
    Parameter{.name = "interpolation",
              .meaning = "between the centres of the neighbouring valid cells, or the cell that "
                         "holds the directions",
              .unit = "1",
              .type = ParameterType::word,
              .words = kInterpolations}};
constexpr ModelDescription kMeasured{
    .name = "measured",
    .summary =
        "a table of measurements (MERL .binary), stored with the server or read from a local file",
    .source =
        "Matusik, Pfister, Brand & McMillan 2003, A Data-Driven Reflectance Model; Rusinkiewicz "
        "1998",
    .role = Role::measured,
    .parameters = kMeasuredParameters,
    .fast = {.relative = 1e-5,
             .note = "of the largest of the table's cells that are interpolated; nearest: away "
                     "from cell boundaries"},
    .reference = {.relative = 1e-10,
                  .note = "of the largest of the table's cells that are interpolated; nearest: "
                          "away from cell boundaries"},
    .albedo_limit = 0};

// Kernels turn the directions of kinds that have_tangents(): those of all models that do.
template <class... Kinds>
constexpr bool all_have_tangents(TypeList<Kinds...>) {
  return (has_tangents<Kinds>() && ...);
}
template <class... Models>
constexpr bool kernels_see_tangents(TypeList<Models...>) {
  return (
      (Models::kDescription.has_tangents() ? all_have_tangents(typename Models::Kinds{}) : true) &&
      ...);
}
static_assert(kernels_see_tangents(AllModels{}));

template <class... Models>
std::vector<ModelDescription> describe(TypeList<Models...>) {
  return {Models::kDescription..., kMeasured};
}

struct Prepared {
  std::shared_ptr<const void> constants;
  std::size_t bytes;
};
template <class S>
using PrepareFn = Prepared (*)(const ParameterValues<S>& values, int channels);

// How a material's tangents are turned, which its lobes' values say in degrees.
template <class S>
Tangents<S> tangents_of(const ParameterValues<S>& values) {
  const auto found = values.all().find(kRotation.name);
  if (found == values.all().end()) return {};
  const S degrees = found->second.front();
  return {rotation_by(degrees), is_turn(degrees)};
}

template <class Kind, class S>
Prepared prepare_kind(const ParameterValues<S>& values, int channels) {
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

// What prepares the kinds of all models, and which kind is each model's first.
template <class S, class... Kinds>
std::vector<PrepareFn<S>> prepare_functions(TypeList<Kinds...>) {
  return {&prepare_kind<Kinds, S>...};
}

template <class... Kinds>
constexpr std::size_t count(TypeList<Kinds...>) {
  return sizeof...(Kinds);
}

template <class... Models>
std::vector<std::size_t> first_kinds(TypeList<Models...>) {
  std::size_t next = 0;
  return {std::exchange(next, next + count(typename Models::Kinds{}))...};
}

template <class S>
PreparedLobe prepare_as(const ModelDescription& model, std::size_t kind,
                        const ParameterValues<S>& values, int channels) {
  static const std::vector<std::size_t> first = first_kinds(AllModels{});
  static const std::vector<PrepareFn<S>> functions = prepare_functions<S>(AllKinds{});
  const std::size_t index = first[static_cast<std::size_t>(&model - models().data())] + kind;
  Prepared prepared = functions[index](values, channels);
  return {index, std::move(prepared.constants), prepared.bytes};
}

}  // namespace

std::span<const ModelDescription> models() {
  static const std::vector<ModelDescription> all = describe(AllModels{});
  return all;
}

Result<const ModelDescription*> find_model(std::string_view name) {
  std::vector<std::string_view> known;
  for (const ModelDescription& model : models()) {
    if (model.name == name) return &model;
    known.push_back(model.name);
  }
  return unknown_word("model", name, known, ErrorCode::not_found);
}

PreparedLobe prepare(const ModelDescription& model, std::size_t kind,
                     const ParameterValues<double>& values, int channels) {
  return prepare_as(model, kind, values, channels);
}

PreparedLobe prepare_derivative(const ModelDescription& model, std::size_t kind,
                                const ParameterValues<double>& values, int channels,
                                std::string_view by) {
  ParameterValues<Dual<double>> seeded;
  for (const auto& [name, numbers] : values.all()) {
    std::vector<Dual<double>> duals;
    for (const double number : numbers) duals.emplace_back(number, name == by ? 1.0 : 0.0);
    seeded.set(name, std::move(duals));
  }
  return prepare_as(model, kind, seeded, channels);
}

PreparedLobe prepare_extended(const ModelDescription& model, std::size_t kind,
                              const ParameterValues<double>& values, int channels) {
  ParameterValues<LongDouble> extended;
  for (const auto& [name, numbers] : values.all())
    extended.set(name, {numbers.begin(), numbers.end()});
  return prepare_as(model, kind, extended, channels);
}

}  // namespace gonio
