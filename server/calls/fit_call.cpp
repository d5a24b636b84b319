// One Fit call: the fit, with its progress. Thread safety: see progress_call.h.
#include <utility>

#include "server/calls/progress_call.h"
#include "server/calls/start_calls.h"
#include "server/messages/fit_messages.h"
#include "server/messages/fit_request.h"
#include "wire/mapping/certificate.h"
#include "wire/message.h"

namespace gonio::server {
namespace {

// The core knows the fields of the form, not what a request calls it.
Error within_request(Error error) {
  const bool of_form =
      error.code == ErrorCode::invalid_argument || error.code == ErrorCode::not_found;
  const bool of_data = error.field == "values";
  if (!of_form || of_data || error.field.rfind("options.", 0) == 0) return error;
  if (error.field == "material") error.field.clear();
  const std::string field = error.field.empty() ? "form" : "form." + error.field;
  if (!error.field.empty() && error.message.rfind(error.field, 0) == 0)
    error.message.replace(0, error.field.size(), field);
  error.field = field;
  return error;
}

grpc::ByteBuffer to_event(const fit::Progress& progress) {
  v1::FitResponse response;
  *response.mutable_progress() = wire::to_message(progress);
  return wire::to_buffer(response);
}

class FitCall final : public ProgressCall {
 public:
  FitCall(const Backend& backend, grpc::CallbackServerContext& context);

 private:
  Result<std::size_t> prepare(const grpc::ByteBuffer& request) override;
  Result<grpc::ByteBuffer> work() override;

  v1::FitRequest request_;  // empty once the data are taken from it
  FitTask task_;
};

FitCall::FitCall(const Backend& backend, grpc::CallbackServerContext& context)
    : ProgressCall(backend, context, "Fit", "the fit") {
  note(to_event({.stage = "queued"}));
}

Result<std::size_t> FitCall::prepare(const grpc::ByteBuffer& buffer) {
  auto request = decode_fit_request(buffer);
  if (!request) return request.error();
  request_ = std::move(*request);
  auto task = fit_task(request_, background().backend().materials);
  if (!task) return task.error();
  task_ = std::move(*task);
  return task_.bytes;
}

Result<grpc::ByteBuffer> FitCall::work() {
  note(to_event({.stage = "data"}));
  const auto data = fit_data(request_, task_);
  if (!data) return data.error();
  request_.Clear();
  background().access().items = data->size();
  fit::Watch watch;
  watch.progress = [this](const fit::Progress& progress) { note(to_event(progress)); };
  watch.stop = [this] { return background().should_stop(); };
  const auto result = fit::fit(*data, task_.form, task_.options, watch);
  if (!result) return within_request(result.error());
  background().access().kernel_seconds = result->certificate.cpu_seconds;
  v1::FitResponse response;
  *response.mutable_result() = to_wire(*result);
  return wire::to_buffer(response);
}

}  // namespace

ProgressReactor* start_fit(const Backend& backend, grpc::CallbackServerContext& context,
                           const grpc::ByteBuffer& request) {
  return ProgressCall::start<FitCall>(backend, context, request);
}

}  // namespace gonio::server
