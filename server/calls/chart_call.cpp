// One Chart call: the measurements, with their progress. Thread safety: see progress_call.h.
#include <utility>

#include "server/calls/progress_call.h"
#include "server/calls/start_calls.h"
#include "server/messages/chart_request.h"
#include "wire/mapping/chart_table.h"
#include "wire/message.h"

namespace gonio::server {
namespace {

grpc::ByteBuffer to_event(const chart::Progress& progress) {
  v1::ChartResponse response;
  *response.mutable_progress() = wire::to_message(progress);
  return wire::to_buffer(response);
}

class ChartCall final : public ProgressCall {
 public:
  ChartCall(const Backend& backend, grpc::CallbackServerContext& context);

 private:
  Result<std::size_t> prepare(const grpc::ByteBuffer& request) override;
  Result<grpc::ByteBuffer> work() override;

  ChartTask task_;
};

ChartCall::ChartCall(const Backend& backend, grpc::CallbackServerContext& context)
    : ProgressCall(backend, context, "Chart", "the chart") {
  note(to_event({.stage = "queued"}));
}

Result<std::size_t> ChartCall::prepare(const grpc::ByteBuffer& buffer) {
  auto request = decode_chart_request(buffer);
  if (!request) return request.error();
  auto task = chart_task(std::move(*request), background().backend().materials);
  if (!task) return task.error();
  task_ = std::move(*task);
  return task_.bytes;
}

Result<grpc::ByteBuffer> ChartCall::work() {
  const auto wanted = chart_wanted(task_);
  if (!wanted) return wanted.error();
  task_.options.stop = [this] { return background().should_stop(); };
  auto tables = chart::measure(*wanted, task_.options, [this](std::string_view part, double done) {
    note(to_event({std::string(part), done}));
  });
  if (!tables) return tables.error();
  for (const chart::Table& table : *tables) background().access().items += table.rows.size();
  v1::ChartResponse response;
  *response.mutable_result() = to_wire(std::move(*tables), chart::this_machine());
  return wire::to_buffer(response);
}

}  // namespace

ProgressReactor* start_chart(const Backend& backend, grpc::CallbackServerContext& context,
                             const grpc::ByteBuffer& request) {
  return ProgressCall::start<ChartCall>(backend, context, request);
}

}  // namespace gonio::server
