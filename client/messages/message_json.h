// Messages as JSON. Internal to the client library. Thread safety: functions without state.
#pragma once

#include <string>

#include "gonio/base/result.h"
#include "gonio/client/material.h"

namespace google::protobuf {
class Message;
}
namespace gonio::v1 {
class Material;
}

namespace gonio::client {

// The same text for the same message, always. Its fields named as in the .proto, those of numbers
// there also where they are 0.
Result<std::string> json_of(const google::protobuf::Message& message);
// On one line, without what is not given.
Result<std::string> brief_json_of(const google::protobuf::Message& message);

Result<Material> material_of(const gonio::v1::Material& material);

}  // namespace gonio::client
