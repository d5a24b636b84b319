#include <grpcpp/impl/codegen/proto_utils.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "client/client.h"
#include "client/fit_convert.h"
#include "client/open_call.h"
#include "client/state.h"

namespace gonio::client {
namespace {

using Clock = std::chrono::system_clock;

constexpr std::chrono::milliseconds kAsk{50};  // how often `stop` is asked while nothing comes
// How long gRPC's own news of a deadline may take: after that the connection hangs.
constexpr std::chrono::milliseconds kGrace{200};

enum Tag : std::intptr_t { started = 1, wrote, read, finished };

void* as_pointer(Tag tag) { return reinterpret_cast<void*>(static_cast<std::intptr_t>(tag)); }

Error cancelled() { return {ErrorCode::cancelled, "the fit was cancelled", {}, {}, {}}; }

template <class Message>
grpc::ByteBuffer to_buffer(const Message& message) {
  grpc::ByteBuffer buffer;
  bool own = false;
  grpc::SerializationTraits<Message>::Serialize(message, &buffer, &own);
  return buffer;
}

// One try of a Fit call.
class FitAttempt {
 public:
  FitAttempt(const Peer& peer, const Patience& patience, const FitWatch& watch)
      : peer_(peer.name),
        watch_(watch),
        call_(new OpenCall(patience, std::make_unique<grpc::CompletionQueue>())) {
    grpc::GenericStub stub(peer.channel);
    call_->stream = stub.PrepareCall(&call_->context, kFitMethod, call_->queue.get());
  }

  // The result. None: the call has ended without, see failure(). Errors: stopped by the caller.
  Result<std::optional<gonio::v1::FitResult>> run(const grpc::ByteBuffer& request) {
    call_->outgoing = request;
    call_->stream->StartCall(as_pointer(started));
    std::optional<gonio::v1::FitResult> result;
    for (;;) {
      const auto event = next();
      if (!event) return event.error();
      if (!*event) return result;
      if (**event == started) begin();
      if (**event != read) continue;
      take(result);
      call_->stream->Read(&call_->incoming, as_pointer(read));
    }
  }

  Failure failure() {
    call_->stream->Finish(&call_->status, as_pointer(finished));
    for (;;) {
      const auto event = next();
      if (!event) return {event.error(), false, std::nullopt};
      if (!*event || **event == finished) break;
    }
    if (!call_->status.ok()) return failure_of(call_->status, call_->context, peer_);
    return {Error{ErrorCode::internal, peer_ + " ended the fit without a result", {}, {}, {}},
            false, std::nullopt};
  }

 private:
  void begin() {
    call_->stream->WriteLast(call_->outgoing, grpc::WriteOptions(), as_pointer(wrote));
    call_->stream->Read(&call_->incoming, as_pointer(read));
  }

  void take(std::optional<gonio::v1::FitResult>& result) {
    gonio::v1::FitResponse response;
    const bool readable =
        grpc::SerializationTraits<gonio::v1::FitResponse>::Deserialize(&call_->incoming, &response)
            .ok();
    if (!readable) return;
    if (response.has_result()) result = std::move(*response.mutable_result());
    if (response.has_progress() && watch_.progress)
      watch_.progress(progress_of(response.progress()));
  }

  // What has happened next; none at the end of the call, an error if the caller wants it to end.
  Result<std::optional<Tag>> next() {
    for (;;) {
      if (watch_.stop && watch_.stop()) return cancelled();
      if (Clock::now() > late_) return hangs();
      void* tag = nullptr;
      bool ok = false;
      const auto status = call_->queue->AsyncNext(&tag, &ok, Clock::now() + kAsk);
      if (status == grpc::CompletionQueue::TIMEOUT) continue;
      const auto known = static_cast<Tag>(reinterpret_cast<std::intptr_t>(tag));
      const bool over = !ok && (known == started || known == read);
      if (status == grpc::CompletionQueue::SHUTDOWN || over) return std::optional<Tag>();
      return std::optional<Tag>(known);
    }
  }

  Error hangs() const {
    return {
        ErrorCode::deadline_exceeded, peer_ + " did not answer within the deadline", {}, {}, {}};
  }

  std::string peer_;
  const FitWatch& watch_;
  OpenCallPointer call_;
  Clock::time_point late_ = call_->context.deadline() == Clock::time_point::max()
                                ? Clock::time_point::max()
                                : call_->context.deadline() + kGrace;
};

}  // namespace

Result<FitResult> Client::fit(const FitData& data, const Material& form, const FitOptions& options,
                              const FitWatch& watch) const {
  const auto request = fit_request(data, form, options);
  if (!request) return request.error();
  const grpc::ByteBuffer bytes = to_buffer(*request);
  Patience patience(state_->options, options.deadline);
  for (;;) {
    FitAttempt attempt(state_->peer, patience, watch);
    const auto result = attempt.run(bytes);
    if (!result) return result.error();
    if (*result) return fit_result_of(**result);
    const Failure failure = attempt.failure();
    if (!patience.pause_to_retry(failure)) return failure.error;
  }
}

}  // namespace gonio::client
