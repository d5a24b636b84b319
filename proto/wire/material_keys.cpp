#include "wire/material_keys.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>

#include <string>
#include <vector>

#include "base/near_names.h"
#include "base/text/join.h"
#include "gonio/v1/material.pb.h"

namespace gonio::wire {
namespace {

namespace pb = google::protobuf;

const pb::FieldDescriptor* field_of(const pb::Descriptor& message, const std::string& key) {
  for (int i = 0; i < message.field_count(); ++i) {
    const pb::FieldDescriptor& field = *message.field(i);
    if (field.name() == key || field.json_name() == key) return &field;
  }
  return nullptr;
}

Error unknown_key(const pb::Descriptor& message, const std::string& at, const std::string& key) {
  std::vector<std::string> known;
  for (int i = 0; i < message.field_count(); ++i) known.push_back(message.field(i)->name());
  std::string hint = did_you_mean(key, std::span<const std::string>(known));
  if (hint.empty()) hint = R"(; what a model takes stands within "parameters")";
  return bad_value(at + key, "not a field", joined(known) + hint);
}

Outcome check(const pb::Struct& object, const pb::Descriptor& message, const std::string& at);

// The keys of parameters are not checked; other nested messages have keys of their own.
Outcome check_value(const pb::Value& value, const pb::Descriptor& message, const std::string& at) {
  if (&message == pb::Struct::descriptor() || !value.has_struct_value()) return Ok{};
  return check(value.struct_value(), message, at + ".");
}

Outcome check(const pb::Struct& object, const pb::Descriptor& message, const std::string& at) {
  for (const auto& [key, value] : object.fields()) {
    const pb::FieldDescriptor* field = field_of(message, key);
    if (field == nullptr) return unknown_key(message, at, key);
    if (field->message_type() == nullptr) continue;
    Outcome good = check_value(value, *field->message_type(), at + key);
    for (int i = 0; good && field->is_repeated() && i < value.list_value().values_size(); ++i) {
      good = check_value(value.list_value().values(i), *field->message_type(),
                         at + key + "[" + std::to_string(i) + "]");
    }
    if (!good) return good;
  }
  return Ok{};
}

}  // namespace

Outcome check_material_keys(std::string_view json) {
  pb::Struct object;
  const auto status =
      pb::util::JsonStringToMessage(pb::StringPiece(json.data(), json.size()), &object);
  if (!status.ok()) return Ok{};
  return check(object, *v1::Material::descriptor(), "material.");
}

}  // namespace gonio::wire
