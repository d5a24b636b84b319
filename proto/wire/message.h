// Messages to bytes and from them, those of the hot path apart (see codec.h). Thread safety:
// functions without state.
#pragma once

#include <google/protobuf/message_lite.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/support/byte_buffer.h>

#include <cstddef>
#include <string>

namespace gonio::wire {

// In bytes: what a server can be told to take. Protobuf itself ends at twice this.
inline constexpr std::size_t kLargestMessage = std::size_t{1} << 30;

// Of a message of no more than kLargestMessage.
template <class Message>
grpc::ByteBuffer to_buffer(const Message& message) {
  grpc::ByteBuffer buffer;
  bool own = false;
  grpc::SerializationTraits<Message>::Serialize(message, &buffer, &own);
  return buffer;
}

// Takes the buffer. False for bytes that are no such message.
template <class Message>
bool from_buffer(grpc::ByteBuffer& buffer, Message& message) {
  return grpc::SerializationTraits<Message>::Deserialize(&buffer, &message).ok();
}

// The same bytes for the same message, always: its own SerializeAsString() has the entries of maps,
// such as parameters, in any order.
std::string to_bytes(const google::protobuf::MessageLite& message);

}  // namespace gonio::wire
