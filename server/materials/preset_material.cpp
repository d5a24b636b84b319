#include "server/materials/preset_material.h"

#include <algorithm>
#include <set>

#include "gonio/engine/registry.h"

namespace gonio::server {
namespace {

constexpr std::string_view kSurface = "ggx";

bool holds(const Parameter& parameter, std::string_view name) {
  const auto& presets = parameter.presets;
  return std::any_of(presets.begin(), presets.end(),
                     [&](const Preset& preset) { return preset.name == name; });
}

}  // namespace

std::optional<v1::Material> preset_material(std::string_view name) {
  std::vector<const Parameter*> holders;
  for (const Parameter& parameter : (*find_model(kSurface))->parameters) {
    if (holds(parameter, name)) holders.push_back(&parameter);
  }
  if (holders.empty()) return std::nullopt;
  // The index says more than the reflectance that follows from it.
  const auto in_pairs = [](const Parameter* p) { return !p->preset_partner.empty(); };
  const bool indexed = std::any_of(holders.begin(), holders.end(), in_pairs);
  v1::Material material;
  material.set_model(std::string(kSurface));
  for (const Parameter* parameter : holders) {
    if (indexed && !in_pairs(parameter)) continue;
    auto& fields = *material.mutable_parameters()->mutable_fields();
    fields[std::string(parameter->name)].set_string_value(std::string(name));
  }
  return material;
}

std::vector<std::string> preset_names() {
  std::set<std::string> names;
  for (const Parameter& parameter : (*find_model(kSurface))->parameters) {
    for (const Preset& preset : parameter.presets) names.emplace(preset.name);
  }
  return {names.begin(), names.end()};
}

}  // namespace gonio::server
