// One Assess call: it waits in the queue of fits and runs on a thread of theirs, so that no
// evaluation waits for it; asked again and again whether its caller still waits.
//
// The call owns itself until gRPC is done with it and the queue has let go of it.
#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <memory>
#include <optional>
#include <utility>

#include "assess/assess.h"
#include "assess/verdict.h"
#include "base/happens_before.h"
#include "server/calls/start_calls.h"
#include "server/messages/assess_request.h"
#include "server/work/background_work.h"
#include "wire/convert.h"
#include "wire/message.h"
#include "wire/status.h"

namespace gonio::server {
namespace {

class AssessCall final : public grpc::ServerUnaryReactor,
                         public std::enable_shared_from_this<AssessCall> {
 public:
  static AssessCall* start(const Backend& backend, grpc::CallbackServerContext& context,
                           const grpc::ByteBuffer& request, grpc::ByteBuffer& response);

 private:
  AssessCall(const Backend& backend, grpc::CallbackServerContext& context,
             grpc::ByteBuffer& response);
  void OnCancel() override;
  void OnDone() override;

  Outcome enqueue(const grpc::ByteBuffer& request);
  void run();
  void end(grpc::Status status) noexcept;

  BackgroundWork background_;
  grpc::ByteBuffer& response_;
  std::optional<PreparedMaterial> material_;
  assess::Options options_;
  Isa isa_ = Isa::baseline;
  std::shared_ptr<AssessCall> self_;
};

AssessCall::AssessCall(const Backend& backend, grpc::CallbackServerContext& context,
                       grpc::ByteBuffer& response)
    : background_(backend, context, "Assess", "the assessment"), response_(response) {}

AssessCall* AssessCall::start(const Backend& backend, grpc::CallbackServerContext& context,
                              const grpc::ByteBuffer& request, grpc::ByteBuffer& response) {
  const std::shared_ptr<AssessCall> call(new AssessCall(backend, context, response));
  call->self_ = call;
  happens_before(call->background_.state());
  try {
    if (const auto queued = call->enqueue(request); !queued)
      call->end(wire::to_status(queued.error()));
  } catch (...) {
    call->end(call->background_.status_of(std::current_exception()));
  }
  return call.get();
}

Outcome AssessCall::enqueue(const grpc::ByteBuffer& buffer) {
  auto request = decode_assess_request(buffer);
  if (!request) return request.error();
  auto material = background_.backend().materials.resolve(
      request->has_material() ? std::optional(wire::to_bytes(request->material())) : std::nullopt);
  if (!material) return material.error();
  material_ = std::move(*material);
  options_ = assess_options(*request);
  if (auto checked = assess::check_options(options_); !checked) return checked;
  const auto isa = choose_isa(request->instruction_set());
  if (!isa) return isa.error();
  isa_ = *isa;
  const auto self = shared_from_this();
  return background_.submit(
      assess::memory_of(material_->material().channels(), options_), [self] { self->run(); },
      [self](grpc::Status status) { self->end(std::move(status)); });
}

void AssessCall::run() {
  if (background_.is_over()) return end(wire::to_status(background_.over()));
  const auto report = assess::assess(material_->sampler(), options_, isa_,
                                     [this] { return background_.should_stop(); });
  if (!report) return end(wire::to_status(background_.error_of(report.error())));
  for (const auto& place : report->places) background_.access().items += place.pairs;
  background_.access().kernel_seconds = report->cpu_seconds;
  v1::AssessResponse response = to_wire(*report);
  response.set_instruction_set(wire::to_wire(isa_));
  response_ = wire::to_buffer(response);
  end(grpc::Status::OK);
}

void AssessCall::end(grpc::Status status) noexcept {
  background_.ended(status);
  happens_before(this);
  Finish(std::move(status));  // gRPC may be done with this
}

void AssessCall::OnCancel() {
  const Reaction reaction(this, background_.state());
  background_.cancel();
}

void AssessCall::OnDone() {
  happens_after(this);
  const Backend& backend = background_.backend();
  self_.reset();
  backend.call_ends();
}

}  // namespace

UnaryReactor* start_assess(const Backend& backend, grpc::CallbackServerContext& context,
                           const grpc::ByteBuffer& request, grpc::ByteBuffer& response) {
  return AssessCall::start(backend, context, request, response);
}

}  // namespace gonio::server
