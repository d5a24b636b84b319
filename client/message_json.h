// Messages as JSON. Internal to the client library. Thread safety: functions without state.
#pragma once

#include <string>

#include "base/result.h"
#include "client/material.h"

namespace google::protobuf {
class Message;
}
namespace gonio::v1 {
class Material;
}

namespace gonio::client {

// Its fields named as in the .proto, those of numbers there also where they are 0. Parameters come
// in the order of their names, so that what is equal is equal to the byte.
Result<std::string> json_of(const google::protobuf::Message& message);

// The same in one line, without what has its default.
Result<std::string> short_json_of(const google::protobuf::Message& message);

Result<Material> material_of(const gonio::v1::Material& material);

}  // namespace gonio::client
