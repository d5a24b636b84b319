#include "server/calls/unary_call.h"

#include "server/calls/start_calls.h"
#include "server/work/evaluation.h"
#include "server/work/integration.h"
#include "server/work/sampling.h"

namespace gonio::server {

UnaryReactor* start_evaluate(const Backend& backend, grpc::CallbackServerContext& context,
                             const grpc::ByteBuffer& request, grpc::ByteBuffer& response) {
  return UnaryCall<Evaluation>::start(backend, context, request, response);
}

UnaryReactor* start_sample(const Backend& backend, grpc::CallbackServerContext& context,
                           const grpc::ByteBuffer& request, grpc::ByteBuffer& response) {
  return UnaryCall<Sampling>::start(backend, context, request, response);
}

UnaryReactor* start_integrate(const Backend& backend, grpc::CallbackServerContext& context,
                              const grpc::ByteBuffer& request, grpc::ByteBuffer& response) {
  return UnaryCall<Integration>::start(backend, context, request, response);
}

}  // namespace gonio::server
