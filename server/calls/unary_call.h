// One unary call. `W` is the work that it asks for: Evaluation, Sampling or Integration. Made by
// start(), it deletes itself when gRPC is done with it. Thread safety: its steps follow each other.
#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <exception>
#include <memory>
#include <utility>

#include "server/calls/call.h"
#include "server/calls/failure.h"
#include "wire/codec.h"
#include "wire/status.h"

namespace gonio::server {

template <class W>
class UnaryCall final : public grpc::ServerUnaryReactor {
 public:
  static UnaryCall* start(const Backend& backend, grpc::CallbackServerContext& context,
                          const grpc::ByteBuffer& request, grpc::ByteBuffer& response);

 private:
  UnaryCall(const Backend& backend, grpc::CallbackServerContext& context,
            grpc::ByteBuffer& response);
  void handle(const grpc::ByteBuffer& request);
  void answer(W& work, bool completed);
  WorkEnd end_of(std::shared_ptr<W> work);
  void refuse(const Error& error);
  void fail(const std::exception_ptr& failure) noexcept;
  void end(grpc::Status status);
  void OnCancel() override;
  void OnDone() override;

  const Backend& backend_;
  grpc::CallbackServerContext& context_;
  grpc::ByteBuffer& response_;
  CallState state_;
  AccessLine access_;
  MemoryBudget::Charge charge_;  // until the answer is sent
};

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
void UnaryCall<W>::handle(const grpc::ByteBuffer& buffer) try {
  const auto request = wire::decode<typename W::Request>(buffer);
  if (!request) return refuse(request.error());
  auto material = backend_.materials.resolve(request->material);
  if (!material) return refuse(material.error());
  const auto prepared = W::prepare(*request, std::move(*material), backend_.max_message_bytes);
  if (!prepared) return refuse(prepared.error());
  access_.batches = 1;
  access_.items = (*prepared)->items();
  const auto computed = compute(backend_, *prepared, state_, end_of(*prepared));
  if (computed) return;
  context_.AddTrailingMetadata(wire::kRetryPushback, kPushbackMilliseconds);
  refuse(computed.error());
} catch (...) {
  fail(std::current_exception());
}

template <class W>
WorkEnd UnaryCall<W>::end_of(std::shared_ptr<W> work) {
  return {[this, work = std::move(work)](bool completed) { answer(*work, completed); },
          [this](const std::exception_ptr& failure) { fail(failure); }};
}

template <class W>
void UnaryCall<W>::answer(W& work, bool completed) try {
  if (!completed) {
    const bool late = state_.past_deadline();
    return end({late ? grpc::StatusCode::DEADLINE_EXCEEDED : grpc::StatusCode::CANCELLED,
                "the call was over before its batch was computed"});
  }
  access_.kernel_seconds = work.kernel_seconds();
  charge_ = work.take_charge();
  response_ = wire::encode_response(work.take_answer());
  end(grpc::Status::OK);
} catch (...) {
  fail(std::current_exception());
}

template <class W>
void UnaryCall<W>::refuse(const Error& error) {
  access_.failed = 1;
  end(wire::to_status(error));
}

template <class W>
void UnaryCall<W>::fail(const std::exception_ptr& failure) noexcept {
  access_.failed = 1;
  end(status_of_failure(access_.method, failure, backend_.logger));
}

// Throws only before gRPC has been told of the end.
template <class W>
void UnaryCall<W>::end(grpc::Status status) {
  access_.write(backend_.logger, status);
  happens_before(this);
  Finish(std::move(status));  // may delete this
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

}  // namespace gonio::server
