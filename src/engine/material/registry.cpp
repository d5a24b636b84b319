#include "engine/material/registry.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/near_names.h"
#include "gonio/engine/registry.h"

#ifndef GONIO_MODEL_LIST  // a test adds a model of its own
#define GONIO_MODEL_LIST "models/list.h"
#endif

namespace gonio {

#define GONIO_MODEL(name, Type) extern const PartModel k##Type##Model;
#define GONIO_FORMAT(Type) extern const PartModel k##Type##Model;
#include GONIO_MODEL_LIST
#undef GONIO_MODEL
#undef GONIO_FORMAT

namespace {

std::span<const PartModel* const> entries() {
#define GONIO_MODEL(name, Type) &k##Type##Model,
#define GONIO_FORMAT(Type) &k##Type##Model,
  static constexpr std::array kAll{
#include GONIO_MODEL_LIST
  };
#undef GONIO_MODEL
#undef GONIO_FORMAT
  return kAll;
}

}  // namespace

std::span<const ModelDescription> models() {
  static const std::vector<ModelDescription> all = [] {
    std::vector<ModelDescription> descriptions;
    for (const PartModel* entry : entries()) descriptions.push_back(entry->description);
    return descriptions;
  }();
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

const PartModel& part_model(const ModelDescription& model) {
  return **std::ranges::find_if(
      entries(), [&](const PartModel* entry) { return entry->description.name == model.name; });
}

Part make_part(const CheckedLobe& lobe, int channels) {
  const PartKind& kind = part_model(*lobe.model).kinds[lobe.kind];
  return {&kind, kind.prepare(lobe, channels), std::make_shared<const CheckedLobe>(lobe), channels};
}

Part make_derivative(const CheckedLobe& lobe, int channels, std::string_view by) {
  const PartKind& kind = part_model(*lobe.model).derivatives[lobe.kind];
  return {&kind, kind.prepare_derivative(lobe, channels, by),
          std::make_shared<const CheckedLobe>(lobe), channels};
}

}  // namespace gonio
