#include "server/service.h"

#include <utility>

#include "server/fit_call.h"
#include "server/list_models.h"
#include "server/stream_call.h"
#include "server/unary_call.h"
#include "wire/status.h"

namespace gonio {

grpc::ServerUnaryReactor* Service::ListModels(grpc::CallbackServerContext* context,
                                              const v1::ListModelsRequest* request,
                                              v1::ListModelsResponse* response) {
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  const AccessLine access("ListModels", *context, backend_.logger);
  auto listed = list_models(*request, backend_.materials);
  const grpc::Status status = listed ? grpc::Status::OK : wire::to_status(listed.error());
  if (listed) *response = std::move(*listed);
  access.write(backend_.logger, status.ok() ? "OK" : status.error_message());
  reactor->Finish(status);
  return reactor;
}

grpc::ServerUnaryReactor* Service::Evaluate(grpc::CallbackServerContext* context,
                                            const grpc::ByteBuffer* request,
                                            grpc::ByteBuffer* response) {
  return UnaryCall::start(backend_, *context, *request, *response);
}

grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* Service::EvaluateStream(
    grpc::CallbackServerContext* context) {
  return new StreamCall(backend_, *context);
}

grpc::ServerWriteReactor<grpc::ByteBuffer>* Service::Fit(grpc::CallbackServerContext* context,
                                                         const grpc::ByteBuffer* request) {
  return FitCall::start(backend_, *context, *request);
}

}  // namespace gonio
