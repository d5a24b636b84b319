#include "server/messages/material_message.h"

#include <string>
#include <vector>

namespace gonio::server {
namespace {

google::protobuf::Value value_of(const ParameterValue& parameter) {
  google::protobuf::Value value;
  if (const auto* word = std::get_if<std::string>(&parameter)) {
    value.set_string_value(*word);
    return value;
  }
  const auto& numbers = std::get<std::vector<double>>(parameter);
  if (numbers.size() == 1) {
    value.set_number_value(numbers[0]);
    return value;
  }
  auto* list = value.mutable_list_value();
  for (const double x : numbers) list->add_values()->set_number_value(x);
  return value;
}

google::protobuf::Struct parameters_of(const LobeSpec& lobe) {
  google::protobuf::Struct parameters;
  for (const auto& [name, value] : lobe.parameters)
    (*parameters.mutable_fields())[name] = value_of(value);
  return parameters;
}

void fill(const LobeSpec& from, v1::Lobe& to) {
  to.set_model(from.model);
  *to.mutable_parameters() = parameters_of(from);
}

}  // namespace

v1::Material to_wire(const MaterialSpec& spec) {
  v1::Material material;
  if (spec.model) {
    material.set_model(spec.model->model);
    *material.mutable_parameters() = parameters_of(*spec.model);
  }
  if (spec.diffuse) fill(*spec.diffuse, *material.mutable_diffuse());
  for (const LobeSpec& lobe : spec.specular) fill(lobe, *material.add_specular());
  if (spec.rotation) material.set_rotation(*spec.rotation);
  return material;
}

}  // namespace gonio::server
