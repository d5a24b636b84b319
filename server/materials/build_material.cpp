#include "server/materials/build_material.h"

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "base/near_names.h"
#include "gonio/measured/table.h"

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

Result<std::string> word(const Value& value, const std::string& field, const std::string& allowed) {
  if (value.kind_case() == Value::kStringValue) return value.string_value();
  return bad_value(field, description_of(value), allowed);
}

constexpr std::array<std::string_view, 2> kInterpolations{"linear", "nearest"};
constexpr std::array<std::string_view, 2> kMeasuredParameters{"file", "interpolation"};

Result<Interpolation> to_interpolation(const Value& value, const std::string& field) {
  const auto text = word(value, field, "linear or nearest");
  if (!text) return text.error();
  if (*text == "linear") return Interpolation::linear;
  if (*text == "nearest") return Interpolation::nearest;
  return unknown_word(field, *text, kInterpolations);
}

Result<Material> build_measured(const Struct& parameters, const std::string& prefix,
                                const FindFile& find_file) {
  if (!find_file) {
    return bad_value(
        prefix + "model", "\"measured\"",
        R"(on this server, measured materials that it stores: {"name": ...}, see ListModels)");
  }
  std::string file;
  Interpolation interpolation = Interpolation::linear;
  for (const auto& [name, value] : parameters.fields()) {
    const std::string field = prefix + "parameters." + name;
    if (name == "file") {
      auto text = word(value, field, "the name of a MERL .binary file");
      if (!text) return text.error();
      file = std::move(*text);
    } else if (name == "interpolation") {
      const auto chosen = to_interpolation(value, field);
      if (!chosen) return chosen.error();
      interpolation = *chosen;
    } else {
      return bad_value(field, "not a parameter of \"measured\"",
                       "file, interpolation" + did_you_mean(name, kMeasuredParameters));
    }
  }
  if (file.empty())
    return bad_value(prefix + "parameters.file", "not given", "the name of a MERL .binary file");
  const auto path = find_file(file);
  if (!path) return path.error();
  auto table = MeasuredTable::read_merl(*path);
  if (!table) return table.error();
  return Material::from_table(std::move(*table), interpolation);
}

// The name of the material itself, from what stands before its fields.
std::string field_of(std::string_view prefix) {
  return prefix.empty() ? "material" : std::string(prefix.substr(0, prefix.size() - 1));
}

}  // namespace

Result<MaterialSpec> material_spec(const v1::Material& material, std::string_view prefix) {
  const auto form = check_form(material, field_of(prefix));
  if (!form) return form.error();
  return to_spec(material, std::string(prefix));
}

Result<Material> build_material(const v1::Material& material, std::string_view prefix,
                                const FindFile& find_file) {
  if (material.model() == kMeasuredModel) {
    const auto form = check_form(material, field_of(prefix));
    if (!form) return form.error();
    const auto rotation = check_rotation(material.rotation(), prefix);
    if (!rotation) return rotation.error();
    return build_measured(material.parameters(), std::string(prefix), find_file);
  }
  const auto spec = material_spec(material, prefix);
  if (!spec) return spec.error();
  return Material::create(*spec, prefix);
}

}  // namespace gonio::server
