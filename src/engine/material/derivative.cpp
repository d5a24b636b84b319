#include "engine/material/derivative.h"

#include <string>
#include <vector>

#include "base/near_names.h"
#include "engine/material/material_impl.h"
#include "engine/material/registry.h"

namespace gonio {
namespace {

std::string field_of(const NamedLobe& lobe, const Parameter& p) {
  return lobe.prefix + "parameters." + std::string(p.name);
}

struct Choice {
  std::vector<std::size_t> lobes;  // that depend on it
  std::string_view parameter;
};

Result<Choice> find_parameter(const CheckedMaterial& material, std::string_view by) {
  if (by == kRotation.name) {
    Choice all{{}, kRotation.name};
    for (std::size_t i = 0; i < material.lobes.size(); ++i) all.lobes.push_back(i);
    return all;
  }
  std::vector<std::string> known;
  for (std::size_t i = 0; i < material.lobes.size(); ++i) {
    for (const Parameter& p : material.lobes[i].model->parameters) {
      if (p.type == ParameterType::word) continue;
      const std::string field = field_of(material.named[i], p);
      if (field == by) return Choice{{i}, p.name};
      known.push_back(field);
    }
  }
  known.emplace_back(kRotation.name);
  return unknown_word("by", by, known);
}

}  // namespace

Result<MaterialDerivative> MaterialDerivative::create(const MaterialSpec& spec,
                                                      std::string_view by) {
  const Result<CheckedMaterial> checked = check_material(spec, {});
  if (!checked) return checked.error();
  const Result<Choice> choice = find_parameter(*checked, by);
  if (!choice) return choice.error();
  auto impl = std::make_shared<Material::Impl>();
  impl->channels = checked->channels;
  for (const std::size_t i : choice->lobes) {
    impl->add(make_derivative(checked->lobes[i], checked->channels, choice->parameter));
  }
  return MaterialDerivative(Material(std::move(impl)));
}

}  // namespace gonio
