#include "client/message_json.h"

#include <google/protobuf/util/json_util.h>

#include "gonio/v1/material.pb.h"

namespace gonio::client {

Result<std::string> json_of(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(message, &json, options);
  if (!status.ok()) return Error{ErrorCode::internal, status.ToString(), {}, {}, {}};
  return json;
}

Result<Material> material_of(const gonio::v1::Material& material) {
  const auto json = json_of(material);
  if (!json) return json.error();
  return Material::from_json(*json);
}

}  // namespace gonio::client
