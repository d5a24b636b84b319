#include "engine/registry.h"

#include <array>
#include <string>
#include <vector>

#include "engine/prepare.h"
#include "models/all.h"

namespace gonio {
namespace {

constexpr std::array<std::string_view, 2> kInterpolations{"linear", "nearest"};
constexpr std::array kMeasuredParameters{
    Parameter{.name = "interpolation",
              .meaning = "between the centres of the neighbouring valid cells, or the cell that "
                         "holds the directions",
              .unit = "1",
              .kind = Kind::word,
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

template <class... Models>
std::vector<ModelDescription> describe(TypeList<Models...>) {
  return {Models::kDescription..., kMeasured};
}

struct Prepared {
  std::shared_ptr<const void> constants;
  std::size_t bytes;
};
using PrepareFn = Prepared (*)(const ParameterValues<double>& values, int channels);

template <class Kind>
Prepared prepare_kind(const ParameterValues<double>& values, int channels) {
  auto constants = std::make_shared<Constants<Kind>>();
  constants->shape = Kind::shape(values);
  constants->channels = channels;
  for (int c = 0; c < channels; ++c) {
    constants->wide[c] = Kind::channel(values, c);
    constants->real[c] = to_float<Kind::template Channel>(constants->wide[c]);
  }
  return {std::move(constants), sizeof(Constants<Kind>)};
}

template <class... Kinds>
void add_kinds(std::vector<PrepareFn>& kinds, TypeList<Kinds...>) {
  (kinds.push_back(&prepare_kind<Kinds>), ...);
}

struct PrepareTable {
  std::vector<PrepareFn> kinds;
  std::vector<std::size_t> first;  // of each model
};

template <class... Models>
PrepareTable prepare_table(TypeList<Models...>) {
  PrepareTable table;
  ((table.first.push_back(table.kinds.size()), add_kinds(table.kinds, typename Models::Kinds{})),
   ...);
  return table;
}

}  // namespace

std::span<const ModelDescription> models() {
  static const std::vector<ModelDescription> all = describe(AllModels{});
  return all;
}

Result<const ModelDescription*> find_model(std::string_view name) {
  std::string known;
  for (const ModelDescription& model : models()) {
    if (model.name == name) return &model;
    known += (known.empty() ? "" : ", ") + std::string(model.name);
  }
  return bad_value("model", '"' + std::string(name) + '"', known, ErrorCode::not_found);
}

PreparedLobe prepare(const ModelDescription& model, std::size_t kind,
                     const ParameterValues<double>& values, int channels) {
  static const PrepareTable table = prepare_table(AllModels{});
  const std::size_t index = table.first[static_cast<std::size_t>(&model - models().data())] + kind;
  Prepared prepared = table.kinds[index](values, channels);
  return {index, std::move(prepared.constants), prepared.bytes};
}

}  // namespace gonio
