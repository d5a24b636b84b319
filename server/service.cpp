#include "server/service.h"

#include <utility>

#include "server/calls/assess_call.h"
#include "server/calls/chart_call.h"
#include "server/calls/fit_call.h"
#include "server/calls/put_call.h"
#include "server/calls/select_call.h"
#include "server/calls/stream_call.h"
#include "server/calls/unary_call.h"
#include "server/messages/list_models.h"
#include "server/work/evaluation.h"
#include "server/work/integration.h"
#include "server/work/sampling.h"
#include "wire/status.h"

template class grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>;

namespace gonio::server {

Service::Service(const Backend& backend) : backend_(backend) { backend_.server_begins(); }

Service::~Service() { backend_.server_ended(); }

grpc::ServerUnaryReactor* Service::ListModels(grpc::CallbackServerContext* context,
                                              const v1::ListModelsRequest* request,
                                              v1::ListModelsResponse* response) {
  backend_.call_begins();
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  const AccessLine access("ListModels", "models", *context, backend_.logger);
  auto listed = list_models(*request, backend_.materials);
  const grpc::Status status = listed ? grpc::Status::OK : wire::to_status(listed.error());
  if (listed) *response = std::move(*listed);
  access.write(backend_.logger, status.ok() ? "OK" : status.error_message());
  backend_.call_ends();
  reactor->Finish(status);
  return reactor;
}

grpc::ServerUnaryReactor* Service::Evaluate(grpc::CallbackServerContext* context,
                                            const grpc::ByteBuffer* request,
                                            grpc::ByteBuffer* response) {
  backend_.call_begins();
  return UnaryCall<Evaluation>::start(backend_, *context, *request, *response);
}

grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* Service::EvaluateStream(
    grpc::CallbackServerContext* context) {
  backend_.stream_begins();
  return new StreamCall<Evaluation>(backend_, *context);
}

grpc::ServerUnaryReactor* Service::Sample(grpc::CallbackServerContext* context,
                                          const grpc::ByteBuffer* request,
                                          grpc::ByteBuffer* response) {
  backend_.call_begins();
  return UnaryCall<Sampling>::start(backend_, *context, *request, *response);
}

grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* Service::SampleStream(
    grpc::CallbackServerContext* context) {
  backend_.stream_begins();
  return new StreamCall<Sampling>(backend_, *context);
}

grpc::ServerUnaryReactor* Service::Integrate(grpc::CallbackServerContext* context,
                                             const grpc::ByteBuffer* request,
                                             grpc::ByteBuffer* response) {
  backend_.call_begins();
  return UnaryCall<Integration>::start(backend_, *context, *request, *response);
}

grpc::ServerWriteReactor<grpc::ByteBuffer>* Service::Fit(grpc::CallbackServerContext* context,
                                                         const grpc::ByteBuffer* request) {
  backend_.call_begins();
  return ProgressCall::start<FitCall>(backend_, *context, *request);
}

grpc::ServerReadReactor<grpc::ByteBuffer>* Service::PutMaterial(
    grpc::CallbackServerContext* context, grpc::ByteBuffer* response) {
  backend_.call_begins();
  return PutCall::start(backend_, *context, *response);
}

grpc::ServerUnaryReactor* Service::Assess(grpc::CallbackServerContext* context,
                                          const grpc::ByteBuffer* request,
                                          grpc::ByteBuffer* response) {
  backend_.call_begins();
  return AssessCall::start(backend_, *context, *request, *response);
}

grpc::ServerWriteReactor<grpc::ByteBuffer>* Service::Select(grpc::CallbackServerContext* context,
                                                            const grpc::ByteBuffer* request) {
  backend_.call_begins();
  return ProgressCall::start<SelectCall>(backend_, *context, *request);
}

grpc::ServerWriteReactor<grpc::ByteBuffer>* Service::Chart(grpc::CallbackServerContext* context,
                                                           const grpc::ByteBuffer* request) {
  backend_.call_begins();
  return ProgressCall::start<ChartCall>(backend_, *context, *request);
}

}  // namespace gonio::server
