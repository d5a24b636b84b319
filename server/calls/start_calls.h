// The calls of the service, each started by a function: what they are made of stays in their own
// files. A call deletes itself when gRPC is done with it, and then says so to the backend:
// call_ends(), or stream_ends(). Thread safety: as gRPC calls them, from any thread.
#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

namespace grpc {
class CallbackServerContext;
}

namespace gonio::server {

struct Backend;

using UnaryReactor = grpc::ServerUnaryReactor;
using ProgressReactor = grpc::ServerWriteReactor<grpc::ByteBuffer>;
using UploadReactor = grpc::ServerReadReactor<grpc::ByteBuffer>;
using StreamReactor = grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>;

UnaryReactor* start_evaluate(const Backend& backend, grpc::CallbackServerContext& context,
                             const grpc::ByteBuffer& request, grpc::ByteBuffer& response);
UnaryReactor* start_sample(const Backend& backend, grpc::CallbackServerContext& context,
                           const grpc::ByteBuffer& request, grpc::ByteBuffer& response);
UnaryReactor* start_integrate(const Backend& backend, grpc::CallbackServerContext& context,
                              const grpc::ByteBuffer& request, grpc::ByteBuffer& response);
UnaryReactor* start_assess(const Backend& backend, grpc::CallbackServerContext& context,
                           const grpc::ByteBuffer& request, grpc::ByteBuffer& response);

StreamReactor* start_evaluate_stream(const Backend& backend, grpc::CallbackServerContext& context);
StreamReactor* start_sample_stream(const Backend& backend, grpc::CallbackServerContext& context);

ProgressReactor* start_fit(const Backend& backend, grpc::CallbackServerContext& context,
                           const grpc::ByteBuffer& request);
ProgressReactor* start_select(const Backend& backend, grpc::CallbackServerContext& context,
                              const grpc::ByteBuffer& request);
ProgressReactor* start_chart(const Backend& backend, grpc::CallbackServerContext& context,
                             const grpc::ByteBuffer& request);

UploadReactor* start_put(const Backend& backend, grpc::CallbackServerContext& context,
                         grpc::ByteBuffer& response);

}  // namespace gonio::server
