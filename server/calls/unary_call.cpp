#include "server/calls/unary_call.h"

#include <grpcpp/server_context.h>

#include <utility>

#include "server/work/evaluation.h"
#include "server/work/integration.h"
#include "server/work/sampling.h"
#include "wire/codec.h"
#include "wire/status.h"

namespace gonio::server {

template <class W>
UnaryCall<W>::UnaryCall(const Backend& backend, grpc::CallbackServerContext& context,
                        grpc::ByteBuffer& response)
    : backend_(backend),
      context_(context),
      response_(response),
      state_(context.deadline()),
      access_(W::kMethod, W::kItems, context, backend.logger) {}

template <class W>
UnaryCall<W>* UnaryCall<W>::start(const Backend& backend, grpc::CallbackServerContext& context,
                                  const grpc::ByteBuffer& request, grpc::ByteBuffer& response) {
  auto* call = new UnaryCall(backend, context, response);
  happens_before(&call->state_);
  call->handle(request);
  return call;
}

template <class W>
void UnaryCall<W>::handle(const grpc::ByteBuffer& buffer) {
  const auto request = wire::decode<typename W::Request>(buffer);
  if (!request) return refuse(request.error());
  auto material = backend_.materials.resolve(request->material);
  if (!material) return refuse(material.error());
  const auto prepared = W::prepare(*request, std::move(*material), backend_.max_message_bytes);
  if (!prepared) return refuse(prepared.error());
  access_.batches = 1;
  access_.items = (*prepared)->items();
  const auto computed =
      compute(backend_, *prepared, state_,
              [this, work = *prepared](bool completed) { answer(*work, completed); });
  if (computed) return;
  context_.AddTrailingMetadata(wire::kRetryPushback, kPushbackMilliseconds);
  refuse(computed.error());
}

template <class W>
void UnaryCall<W>::answer(W& work, bool completed) {
  if (!completed) {
    const bool late = state_.past_deadline();
    return end({late ? grpc::StatusCode::DEADLINE_EXCEEDED : grpc::StatusCode::CANCELLED,
                "the call was over before its batch was computed"});
  }
  access_.kernel_seconds = work.kernel_seconds();
  charge_ = work.take_charge();
  response_ = wire::encode_response(work.take_answer());
  end(grpc::Status::OK);
}

template <class W>
void UnaryCall<W>::refuse(const Error& error) {
  access_.failed = 1;
  end(wire::to_status(error));
}

template <class W>
void UnaryCall<W>::end(const grpc::Status& status) {
  access_.write(backend_.logger, status.ok() ? "OK" : status.error_message());
  happens_before(this);
  Finish(status);  // may delete this
}

template <class W>
void UnaryCall<W>::OnCancel() {
  const Reaction reaction(this, &state_);
  state_.cancel();
}

template <class W>
void UnaryCall<W>::OnDone() {
  happens_after(this);
  const Backend& backend = backend_;
  delete this;
  backend.call_ends();
}

template class UnaryCall<Evaluation>;
template class UnaryCall<Sampling>;
template class UnaryCall<Integration>;

}  // namespace gonio::server
