#include "server/unary_call.h"

#include <grpcpp/server_context.h>

#include <utility>

#include "wire/codec.h"
#include "wire/status.h"

namespace gonio {

UnaryCall::UnaryCall(const Backend& backend, grpc::CallbackServerContext& context,
                     grpc::ByteBuffer& response)
    : backend_(backend),
      context_(context),
      response_(response),
      state_(context.deadline()),
      access_("Evaluate", context, backend.logger) {}

UnaryCall* UnaryCall::start(const Backend& backend, grpc::CallbackServerContext& context,
                            const grpc::ByteBuffer& request, grpc::ByteBuffer& response) {
  auto* call = new UnaryCall(backend, context, response);
  happens_before(&call->state_);
  call->handle(request);
  return call;
}

void UnaryCall::handle(const grpc::ByteBuffer& buffer) {
  const auto request = wire::decode_request(buffer);
  if (!request) return refuse(request.error());
  auto material = backend_.materials.resolve(request->material);
  if (!material) return refuse(material.error());
  const auto prepared =
      Evaluation::prepare(*request, std::move(*material), backend_.max_message_bytes);
  if (!prepared) return refuse(prepared.error());
  access_.batches = 1;
  access_.pairs = (*prepared)->pairs();
  const auto computed =
      compute(backend_, *prepared, state_,
              [this, evaluation = *prepared](bool completed) { answer(*evaluation, completed); });
  if (computed) return;
  context_.AddTrailingMetadata(wire::kRetryPushback, kPushbackMilliseconds);
  refuse(computed.error());
}

void UnaryCall::answer(Evaluation& evaluation, bool completed) {
  if (!completed) {
    const bool late = state_.past_deadline();
    return end({late ? grpc::StatusCode::DEADLINE_EXCEEDED : grpc::StatusCode::CANCELLED,
                "the call was over before its batch was computed"});
  }
  access_.kernel_seconds = evaluation.kernel_seconds();
  charge_ = evaluation.take_charge();
  response_ = wire::encode_response(evaluation.take_answer());
  end(grpc::Status::OK);
}

void UnaryCall::refuse(const Error& error) {
  access_.failed = 1;
  end(wire::to_status(error));
}

void UnaryCall::end(const grpc::Status& status) {
  access_.write(backend_.logger, status.ok() ? "OK" : status.error_message());
  happens_before(this);
  Finish(status);  // may delete this
}

void UnaryCall::OnCancel() {
  const Reaction reaction(this, &state_);
  state_.cancel();
}

void UnaryCall::OnDone() {
  happens_after(this);
  const Backend& backend = backend_;
  delete this;
  backend.call_ends();
}

}  // namespace gonio
