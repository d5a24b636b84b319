#include "server/service.h"

#include <utility>

#include "server/calls/failure.h"
#include "server/calls/start_calls.h"
#include "server/messages/list_models.h"
#include "wire/status.h"

template class grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>;

namespace gonio::server {
namespace {

// Stands for a call that could not be made, and says why.
template <class Reactor>
class Unmade final : public Reactor {
 public:
  explicit Unmade(const grpc::Status& status) { this->Finish(status); }

 private:
  void OnDone() override { delete this; }
};

template <class Start>
auto begin_call(const Backend& backend, const char* method, const Start& start)
    -> decltype(start()) {
  backend.call_begins();
  try {
    return start();
  } catch (...) {
    const auto status = status_of_failure(method, std::current_exception(), backend.logger);
    backend.call_ends();
    return new Unmade<std::remove_pointer_t<decltype(start())>>(status);
  }
}

// The same of a stream.
template <class Start>
StreamReactor* begin_stream(const Backend& backend, const char* method, const Start& start) {
  backend.stream_begins();
  try {
    return start();
  } catch (...) {
    const auto status = status_of_failure(method, std::current_exception(), backend.logger);
    backend.stream_ends();
    return new Unmade<StreamReactor>(status);
  }
}

grpc::Status answer(const v1::ListModelsRequest& request, const Backend& backend,
                    v1::ListModelsResponse& response) {
  auto listed = list_models(request, backend.materials);
  if (!listed) return wire::to_status(listed.error());
  response = std::move(*listed);
  return grpc::Status::OK;
}

}  // namespace

Service::Service(const Backend& backend) : backend_(backend) { backend_.server_begins(); }

Service::~Service() { backend_.server_ended(); }

UnaryReactor* Service::ListModels(grpc::CallbackServerContext* context,
                                  const v1::ListModelsRequest* request,
                                  v1::ListModelsResponse* response) {
  return begin_call(backend_, "ListModels", [&] {
    const AccessLine access("ListModels", "models", *context, backend_.logger);
    const grpc::Status status = answer(*request, backend_, *response);
    UnaryReactor* reactor = context->DefaultReactor();
    access.write(backend_.logger, status);
    backend_.call_ends();
    reactor->Finish(status);
    return reactor;
  });
}

UnaryReactor* Service::Evaluate(grpc::CallbackServerContext* context,
                                const grpc::ByteBuffer* request, grpc::ByteBuffer* response) {
  return begin_call(backend_, "Evaluate",
                    [&] { return start_evaluate(backend_, *context, *request, *response); });
}

StreamReactor* Service::EvaluateStream(grpc::CallbackServerContext* context) {
  return begin_stream(backend_, "EvaluateStream",
                      [&] { return start_evaluate_stream(backend_, *context); });
}

UnaryReactor* Service::Sample(grpc::CallbackServerContext* context, const grpc::ByteBuffer* request,
                              grpc::ByteBuffer* response) {
  return begin_call(backend_, "Sample",
                    [&] { return start_sample(backend_, *context, *request, *response); });
}

StreamReactor* Service::SampleStream(grpc::CallbackServerContext* context) {
  return begin_stream(backend_, "SampleStream",
                      [&] { return start_sample_stream(backend_, *context); });
}

UnaryReactor* Service::Integrate(grpc::CallbackServerContext* context,
                                 const grpc::ByteBuffer* request, grpc::ByteBuffer* response) {
  return begin_call(backend_, "Integrate",
                    [&] { return start_integrate(backend_, *context, *request, *response); });
}

UnaryReactor* Service::Assess(grpc::CallbackServerContext* context, const grpc::ByteBuffer* request,
                              grpc::ByteBuffer* response) {
  return begin_call(backend_, "Assess",
                    [&] { return start_assess(backend_, *context, *request, *response); });
}

ProgressReactor* Service::Fit(grpc::CallbackServerContext* context,
                              const grpc::ByteBuffer* request) {
  return begin_call(backend_, "Fit", [&] { return start_fit(backend_, *context, *request); });
}

ProgressReactor* Service::Select(grpc::CallbackServerContext* context,
                                 const grpc::ByteBuffer* request) {
  return begin_call(backend_, "Select", [&] { return start_select(backend_, *context, *request); });
}

ProgressReactor* Service::Chart(grpc::CallbackServerContext* context,
                                const grpc::ByteBuffer* request) {
  return begin_call(backend_, "Chart", [&] { return start_chart(backend_, *context, *request); });
}

UploadReactor* Service::PutMaterial(grpc::CallbackServerContext* context,
                                    grpc::ByteBuffer* response) {
  return begin_call(backend_, "PutMaterial",
                    [&] { return start_put(backend_, *context, *response); });
}

}  // namespace gonio::server
