#include "server/calls/stream_call.h"

#include "server/calls/start_calls.h"
#include "server/work/evaluation.h"
#include "server/work/sampling.h"

namespace gonio::server {

StreamReactor* start_evaluate_stream(const Backend& backend, grpc::CallbackServerContext& context) {
  return StreamCall<Evaluation>::start(backend, context);
}

StreamReactor* start_sample_stream(const Backend& backend, grpc::CallbackServerContext& context) {
  return StreamCall<Sampling>::start(backend, context);
}

}  // namespace gonio::server
