#include "server/calls/assess_call.h"

#include <grpcpp/server_context.h>

#include <utility>

#include "assess/verdict.h"
#include "base/happens_before.h"
#include "server/messages/assess_request.h"
#include "wire/convert.h"
#include "wire/message.h"
#include "wire/status.h"

namespace gonio::server {

AssessCall::AssessCall(const Backend& backend, grpc::CallbackServerContext& context,
                       grpc::ByteBuffer& response)
    : background_(backend, context, "Assess", "the assessment"), response_(response) {}

AssessCall* AssessCall::start(const Backend& backend, grpc::CallbackServerContext& context,
                              const grpc::ByteBuffer& request, grpc::ByteBuffer& response) {
  const std::shared_ptr<AssessCall> call(new AssessCall(backend, context, response));
  call->self_ = call;
  happens_before(call->background_.state());
  if (const auto queued = call->enqueue(request); !queued)
    call->end(wire::to_status(queued.error()));
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
  return background_.submit(assess::memory_of(material_->material().channels(), options_),
                            [self = shared_from_this()] { self->run(); });
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

void AssessCall::end(const grpc::Status& status) {
  background_.ended(status);
  happens_before(this);
  Finish(status);  // gRPC may be done with this
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

}  // namespace gonio::server
