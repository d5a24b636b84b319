#include "client/message_json.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/type_resolver_util.h>

#include <memory>

#include "gonio/v1/material.pb.h"

namespace gonio::client {

namespace {

namespace pb = google::protobuf;

// MessageToJsonString begins with bytes whose maps are in any order, another in each process.
std::string ordered_bytes(const pb::Message& message) {
  std::string bytes;
  pb::io::StringOutputStream stream(&bytes);
  pb::io::CodedOutputStream coded(&stream);
  coded.SetSerializationDeterministic(true);
  message.SerializeToCodedStream(&coded);
  coded.Trim();
  return bytes;
}

Result<std::string> json_with(const pb::Message& message,
                              const pb::util::JsonPrintOptions& options) {
  constexpr const char* kPrefix = "type.googleapis.com";
  static const std::unique_ptr<pb::util::TypeResolver> types(
      pb::util::NewTypeResolverForDescriptorPool(kPrefix, pb::DescriptorPool::generated_pool()));
  std::string json;
  const auto status = pb::util::BinaryToJsonString(
      types.get(), kPrefix + ("/" + message.GetDescriptor()->full_name()), ordered_bytes(message),
      &json, options);
  if (!status.ok()) return Error{ErrorCode::internal, status.ToString(), {}, {}, {}};
  return json;
}

}  // namespace

Result<std::string> json_of(const pb::Message& message) {
  pb::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  return json_with(message, options);
}

Result<std::string> short_json_of(const pb::Message& message) { return json_with(message, {}); }

Result<Material> material_of(const gonio::v1::Material& material) {
  const auto json = json_of(material);
  if (!json) return json.error();
  return Material::from_json(*json);
}

}  // namespace gonio::client
