// The other end of EchoService.
#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/support/byte_buffer.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace gonio::bench {

// What an echo sends, and what it does with the answers; both by their number.
struct EchoEnds {
  std::function<grpc::ByteBuffer(std::size_t)> message;
  std::function<void(std::size_t, const grpc::ByteBuffer&)> take;
};

// Sends `count` messages over one stream with at most `in_flight` unanswered; false if an answer is
// missing.
bool echo_stream(const std::shared_ptr<grpc::Channel>& channel, const EchoEnds& ends,
                 std::size_t count, std::size_t in_flight);

// One call of a unary raw method; false if it failed.
bool raw_unary(grpc::Channel& channel, const char* method, const grpc::ByteBuffer& request,
               grpc::ByteBuffer& response);

}  // namespace gonio::bench
