#include "client/messages/message_json.h"

#include <google/protobuf/message.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/type_resolver_util.h>

#include <memory>

#include "gonio/base/shown.h"
#include "gonio/v1/material.pb.h"
#include "wire/message.h"

namespace gonio::client {
namespace {

namespace util = google::protobuf::util;

// Protobuf's own way from a message has the entries of maps in any order; that from bytes keeps
// theirs.
Result<std::string> json_of(const google::protobuf::Message& message,
                            const util::JsonPrintOptions& options) {
  constexpr const char* kPrefix = "type.googleapis.com";
  static const std::unique_ptr<util::TypeResolver> types(util::NewTypeResolverForDescriptorPool(
      kPrefix, google::protobuf::DescriptorPool::generated_pool()));
  std::string json;
  const auto status = util::BinaryToJsonString(types.get(), kPrefix + ("/" + message.GetTypeName()),
                                               wire::to_bytes(message), &json, options);
  if (!status.ok()) return Error{ErrorCode::internal, shown(status.ToString()), {}, {}, {}};
  return json;
}

}  // namespace

Result<std::string> json_of(const google::protobuf::Message& message) {
  util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  return json_of(message, options);
}

Result<std::string> brief_json_of(const google::protobuf::Message& message) {
  return json_of(message, {});
}

Result<Material> material_of(const gonio::v1::Material& material) {
  const auto json = json_of(material);
  if (!json) return json.error();
  return Material::from_json(*json);
}

}  // namespace gonio::client
