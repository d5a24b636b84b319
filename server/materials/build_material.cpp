#include "server/materials/build_material.h"

#include <utility>
#include <vector>

#include "gonio/engine/registry.h"

namespace gonio::server {
namespace {

using google::protobuf::Struct;
using google::protobuf::Value;

std::string description_of(const Value& value) {
  switch (value.kind_case()) {
    case Value::kBoolValue:
      return value.bool_value() ? "true" : "false";
    case Value::kNumberValue:
      return "a number";
    case Value::kStringValue:
      return "\"" + value.string_value() + "\"";
    case Value::kStructValue:
      return "an object";
    case Value::kListValue:
      return "an array";
    default:
      return "null";
  }
}

Result<ParameterValue> to_numbers(const google::protobuf::ListValue& list,
                                  const std::string& field) {
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(list.values_size()));
  for (const Value& value : list.values()) {
    if (value.kind_case() != Value::kNumberValue) {
      return bad_value(field + "[" + std::to_string(numbers.size()) + "]", description_of(value),
                       "a number");
    }
    numbers.push_back(value.number_value());
  }
  return ParameterValue(std::move(numbers));
}

Result<ParameterValue> to_parameter(const Value& value, const std::string& field) {
  switch (value.kind_case()) {
    case Value::kNumberValue:
      return ParameterValue(std::vector<double>{value.number_value()});
    case Value::kStringValue:
      return ParameterValue(value.string_value());
    case Value::kListValue:
      return to_numbers(value.list_value(), field);
    default:
      return bad_value(field, description_of(value), "a number, an array of numbers or a word");
  }
}

Result<LobeSpec> to_lobe(const std::string& model, const Struct& parameters,
                         const std::string& prefix) {
  LobeSpec lobe{model, {}};
  for (const auto& [name, value] : parameters.fields()) {
    auto parameter = to_parameter(value, prefix + "parameters." + name);
    if (!parameter) return parameter.error();
    lobe.parameters.emplace(name, std::move(*parameter));
  }
  return lobe;
}

Result<MaterialSpec> to_spec(const v1::Material& material, const std::string& prefix) {
  MaterialSpec spec;
  if (material.has_rotation()) spec.rotation = material.rotation();
  if (!material.model().empty()) {
    auto lobe = to_lobe(material.model(), material.parameters(), prefix);
    if (!lobe) return lobe.error();
    spec.model = std::move(*lobe);
  }
  if (material.has_diffuse()) {
    auto lobe =
        to_lobe(material.diffuse().model(), material.diffuse().parameters(), prefix + "diffuse.");
    if (!lobe) return lobe.error();
    spec.diffuse = std::move(*lobe);
  }
  for (const v1::Lobe& specular : material.specular()) {
    const std::string place = prefix + "specular[" + std::to_string(spec.specular.size()) + "].";
    auto lobe = to_lobe(specular.model(), specular.parameters(), place);
    if (!lobe) return lobe.error();
    spec.specular.push_back(std::move(*lobe));
  }
  return spec;
}

// Exactly one of the forms, no parameters without their model, and not too many lobes.
Outcome check_form(const v1::Material& material, const std::string& field) {
  constexpr const char* kAllowed =
      R"(exactly one of {"name": ...}, {"model": ..., "parameters": {...}} and {"diffuse": ..., "specular": [...]})";
  const bool sum = material.has_diffuse() || material.specular_size() > 0;
  const int forms =
      (material.name().empty() ? 0 : 1) + (material.model().empty() ? 0 : 1) + (sum ? 1 : 0);
  if (forms == 0) return bad_value(field, "empty", kAllowed);
  if (forms > 1) return bad_value(field, "given in " + std::to_string(forms) + " ways", kAllowed);
  if (material.has_parameters() && material.model().empty()) {
    return bad_value(field + ".parameters", "given without a model",
                     "parameters beside \"model\" or within a lobe");
  }
  if (material.specular_size() > kMaxSpecularLobes) {
    return bad_value(field + ".specular", std::to_string(material.specular_size()) + " lobes",
                     "at most " + std::to_string(kMaxSpecularLobes) + " lobes");
  }
  return Ok{};
}

// The name of the material itself, from what stands before its fields.
std::string field_of(std::string_view prefix) {
  return prefix.empty() ? "material" : std::string(prefix.substr(0, prefix.size() - 1));
}

}  // namespace

bool is_measured(const v1::Material& material) {
  const auto model = find_model(material.model());
  return model && (*model)->role == Role::measured;
}

Result<MaterialSpec> material_spec(const v1::Material& material, std::string_view prefix) {
  const auto form = check_form(material, field_of(prefix));
  if (!form) return form.error();
  return to_spec(material, std::string(prefix));
}

Result<Material> build_material(const v1::Material& material, std::string_view prefix,
                                const FindFile& find_file) {
  const auto spec = material_spec(material, prefix);
  if (!spec) return spec.error();
  if (!is_measured(material)) return Material::create(*spec, prefix);
  const auto rotation = check_rotation(material.rotation(), prefix);
  if (!rotation) return rotation.error();
  if (!find_file) {
    return bad_value(
        std::string(prefix) + "model", '"' + material.model() + '"',
        R"(on this server, measured materials that it stores: {"name": ...}, see ListModels)");
  }
  return Material::from_file(*spec->model, prefix, find_file);
}

}  // namespace gonio::server
