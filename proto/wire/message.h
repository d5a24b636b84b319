// Conversion of messages to bytes and back. Those of the hot path are in codec.h. Thread safety:
// functions without state.
#pragma once

#include <google/protobuf/message_lite.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/support/byte_buffer.h>

#include <cstddef>
#include <string>

namespace gonio::wire {

// In bytes: the largest limit that a server can be given. Protobuf's own limit is twice this.
inline constexpr std::size_t kLargestMessage = std::size_t{1} << 30;

// For a message of at most kLargestMessage.
template <class Message>
grpc::ByteBuffer to_buffer(const Message& message) {
  grpc::ByteBuffer buffer;
  bool own = false;
  grpc::SerializationTraits<Message>::Serialize(message, &buffer, &own);
  return buffer;
}

// Consumes the buffer. Returns false for bytes that are no such message.
template <class Message>
bool from_buffer(grpc::ByteBuffer& buffer, Message& message) {
  return grpc::SerializationTraits<Message>::Deserialize(&buffer, &message).ok();
}

// Always the same bytes for the same message: SerializeAsString() writes the entries of maps, such
// as parameters, in any order.
std::string to_bytes(const google::protobuf::MessageLite& message);

}  // namespace gonio::wire
