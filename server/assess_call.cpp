#include "server/assess_call.h"

#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/server_context.h>

#include <algorithm>
#include <string>
#include <utility>

#include "assess/verdict.h"
#include "base/happens_before.h"
#include "server/assess_request.h"
#include "wire/convert.h"
#include "wire/status.h"

namespace gonio {
namespace {

using Clock = std::chrono::system_clock;

}  // namespace

AssessCall::AssessCall(const Backend& backend, grpc::CallbackServerContext& context,
                       grpc::ByteBuffer& response)
    : backend_(backend),
      context_(context),
      response_(response),
      state_(std::min(context.deadline(), Clock::now() + backend.fits.longest)),
      access_("Assess", "pairs", context, backend.logger) {}

AssessCall* AssessCall::start(const Backend& backend, grpc::CallbackServerContext& context,
                              const grpc::ByteBuffer& request, grpc::ByteBuffer& response) {
  const std::shared_ptr<AssessCall> call(new AssessCall(backend, context, response));
  call->self_ = call;
  happens_before(&call->state_);
  if (const auto queued = call->enqueue(request); !queued)
    call->end(wire::to_status(queued.error()));
  return call.get();
}

Outcome AssessCall::enqueue(const grpc::ByteBuffer& buffer) {
  auto request = decode_assess_request(buffer);
  if (!request) return request.error();
  auto material = backend_.materials.resolve(
      request->has_material() ? std::optional(request->material().SerializeAsString())
                              : std::nullopt);
  if (!material) return material.error();
  material_ = std::move(*material);
  options_ = assess_options(*request);
  if (auto checked = assess::check_options(options_); !checked) return checked;
  const auto isa = choose_isa(request->instruction_set());
  if (!isa) return isa.error();
  isa_ = *isa;
  charge_ = backend_.memory.take(assess::memory_of(material_->material().channels(), options_));
  const char* full = charge_ ? "queue of fits and assessments is full" : "memory is full";
  if (charge_) {
    auto self = shared_from_this();
    if (backend_.fits.queue.submit(
            {[self] { self->run(); }, [self] { return self->state_.is_over(); }}))
      return Ok{};
  }
  context_.AddTrailingMetadata(wire::kRetryPushback, kFitPushbackMilliseconds);
  return Error{ErrorCode::resource_exhausted,
               std::string("the server's ") + full + ": send this one again after " +
                   kFitPushbackMilliseconds + " ms",
               {},
               {},
               {}};
}

Error AssessCall::over() const {
  if (!state_.past_deadline())
    return {ErrorCode::cancelled, "the assessment was cancelled", {}, {}, {}};
  const auto longest = std::chrono::duration_cast<std::chrono::seconds>(backend_.fits.longest);
  return {ErrorCode::deadline_exceeded,
          "the assessment was not done within its deadline; this server gives one at most " +
              std::to_string(longest.count()) + " s",
          {},
          {},
          {}};
}

void AssessCall::run() {
  if (state_.is_over()) return end(wire::to_status(over()));
  const auto report = assess::assess(material_->sampler(), options_, isa_, [this] {
    BackgroundQueue::give_way();
    return state_.is_over();
  });
  if (!report) {
    const bool stopped = report.error().code == ErrorCode::cancelled;
    return end(wire::to_status(stopped ? over() : report.error()));
  }
  for (const auto& place : report->places) access_.items += place.pairs;
  access_.kernel_seconds = report->cpu_seconds;
  v1::AssessResponse response = to_wire(*report);
  response.set_instruction_set(wire::to_wire(isa_));
  bool own = false;
  grpc::SerializationTraits<v1::AssessResponse>::Serialize(response, &response_, &own);
  end(grpc::Status::OK);
}

void AssessCall::end(const grpc::Status& status) {
  access_.failed = status.ok() ? 0 : 1;
  access_.write(backend_.logger, status.ok() ? "OK" : status.error_message());
  happens_before(this);
  Finish(status);  // gRPC may be done with this
}

void AssessCall::OnCancel() {
  const Reaction reaction(this, &state_);
  state_.cancel();
  backend_.fits.queue.drop_over();
}

void AssessCall::OnDone() {
  happens_after(this);
  const Backend& backend = backend_;
  self_.reset();
  backend.call_ends();
}

}  // namespace gonio
