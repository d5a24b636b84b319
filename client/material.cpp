#include "gonio/client/material.h"

#include "client/messages/message_json.h"
#include "gonio/v1/material.pb.h"
#include "wire/convert.h"
#include "wire/message.h"

namespace gonio::client {
namespace {

namespace pb = google::protobuf;

pb::Value to_value(const ParameterValue& parameter) {
  pb::Value value;
  if (const auto* number = std::get_if<double>(&parameter)) {
    value.set_number_value(*number);
  } else if (const auto* word = std::get_if<std::string>(&parameter)) {
    value.set_string_value(*word);
  } else {
    auto* list = value.mutable_list_value();
    for (const double n : std::get<std::vector<double>>(parameter)) {
      list->add_values()->set_number_value(n);
    }
  }
  return value;
}

void fill(pb::Struct& target, const Parameters& parameters) {
  for (const auto& [name, value] : parameters) (*target.mutable_fields())[name] = to_value(value);
}

void fill(gonio::v1::Lobe& target, const Lobe& lobe) {
  target.set_model(lobe.model);
  fill(*target.mutable_parameters(), lobe.parameters);
}

}  // namespace

Material Material::named(std::string_view name) {
  gonio::v1::Material message;
  message.set_name(std::string(name));
  return Material(wire::to_bytes(message));
}

Material Material::model(std::string_view name, const Parameters& parameters) {
  gonio::v1::Material message;
  message.set_model(std::string(name));
  fill(*message.mutable_parameters(), parameters);
  return Material(wire::to_bytes(message));
}

Material Material::sum(const std::optional<Lobe>& diffuse, const std::vector<Lobe>& specular) {
  gonio::v1::Material message;
  if (diffuse) fill(*message.mutable_diffuse(), *diffuse);
  for (const Lobe& lobe : specular) fill(*message.add_specular(), lobe);
  return Material(wire::to_bytes(message));
}

Result<Material> Material::from_json(std::string_view json) {
  auto message = wire::material_from_json(json);
  if (!message) return std::move(message).error();
  return Material(wire::to_bytes(*message));
}

Material Material::rotated(double degrees) const {
  gonio::v1::Material message;
  message.ParseFromString(wire_);  // of our own making
  message.set_rotation(degrees);
  return Material(wire::to_bytes(message));
}

std::string Material::to_json() const {
  gonio::v1::Material message;
  if (!message.ParseFromString(wire_)) return "{}";
  const auto json = brief_json_of(message);
  return json ? *json : "{}";
}

}  // namespace gonio::client
