// The other end of EchoService: sends the same bytes again and again, and drops what comes back.
#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/support/byte_buffer.h>

#include <cstddef>
#include <memory>

namespace gonio::bench {

// Sends `message` `count` times over one stream with at most `in_flight` unanswered; false if an
// answer is missing.
bool echo_stream(const std::shared_ptr<grpc::Channel>& channel, const grpc::ByteBuffer& message,
                 std::size_t count, std::size_t in_flight);

// One call of a unary raw method; false if it failed.
bool raw_unary(grpc::Channel& channel, const char* method, const grpc::ByteBuffer& request,
               grpc::ByteBuffer& response);

}  // namespace gonio::bench
