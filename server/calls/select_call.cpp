// One Select call: the selection, with its progress. Thread safety: see progress_call.h.
#include <utility>

#include "server/calls/progress_call.h"
#include "server/calls/start_calls.h"
#include "server/messages/select_messages.h"
#include "server/messages/select_request.h"
#include "wire/mapping/selection.h"
#include "wire/message.h"

namespace gonio::server {
namespace {

grpc::ByteBuffer to_event(const select::Progress& progress) {
  v1::SelectResponse response;
  *response.mutable_progress() = wire::to_message(progress);
  return wire::to_buffer(response);
}

class SelectCall final : public ProgressCall {
 public:
  SelectCall(const Backend& backend, grpc::CallbackServerContext& context);

 private:
  Result<std::size_t> prepare(const grpc::ByteBuffer& request) override;
  Result<grpc::ByteBuffer> work() override;
  Result<select::Selection> choose();

  SelectTask task_;
};

SelectCall::SelectCall(const Backend& backend, grpc::CallbackServerContext& context)
    : ProgressCall(backend, context, "Select", "the selection") {
  note(to_event({.stage = "queued"}));
}

Result<std::size_t> SelectCall::prepare(const grpc::ByteBuffer& buffer) {
  auto request = decode_select_request(buffer);
  if (!request) return request.error();
  auto task = select_task(std::move(*request), background().backend().materials);
  if (!task) return task.error();
  task_ = std::move(*task);
  return task_.bytes;
}

Result<select::Selection> SelectCall::choose() {
  select::Options& options = task_.options;
  options.progress = [this](const std::string& name, std::size_t done, std::size_t of) {
    note(to_event({"candidates", name, done, of}));
  };
  options.stop = [this] { return background().should_stop(); };
  if (task_.material) return select::choose(task_.material->material(), task_.scene, options);
  const auto data = select_data(task_);
  if (!data) return data.error();
  background().access().items = data->size();
  return select::choose(*data, task_.scene, options);
}

Result<grpc::ByteBuffer> SelectCall::work() {
  note(to_event({.stage = "reference"}));
  const auto selection = choose();
  if (!selection) return selection.error();
  v1::SelectResponse response;
  *response.mutable_result() = to_wire(*selection);
  return wire::to_buffer(response);
}

}  // namespace

ProgressReactor* start_select(const Backend& backend, grpc::CallbackServerContext& context,
                              const grpc::ByteBuffer& request) {
  return ProgressCall::start<SelectCall>(backend, context, request);
}

}  // namespace gonio::server
