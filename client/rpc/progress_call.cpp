#include "client/rpc/progress_call.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "client/rpc/open_call.h"

namespace gonio::client {
namespace {

using Clock = std::chrono::system_clock;

constexpr std::chrono::milliseconds kAsk{50};  // how often `stop` is asked while nothing comes
// How long gRPC's own news of a deadline may take: after that the connection hangs.
constexpr std::chrono::milliseconds kGrace{200};

enum Tag : std::intptr_t { started = 1, wrote, read, finished };

void* as_pointer(Tag tag) { return reinterpret_cast<void*>(static_cast<std::intptr_t>(tag)); }

// One try.
class Attempt {
 public:
  Attempt(const Peer& peer, const ProgressMethod& method, const Patience& patience,
          const std::function<bool()>& stop)
      : peer_(peer.name),
        work_(method.work),
        stop_(stop),
        call_(new OpenCall(patience, std::make_unique<grpc::CompletionQueue>())) {
    grpc::GenericStub stub(peer.channel);
    call_->stream = stub.PrepareCall(&call_->context, method.path, call_->queue.get());
  }

  // Whether the result was among what came. If not, the call has ended: see failure(). Errors:
  // stopped by the caller.
  Result<bool> run(const grpc::ByteBuffer& request,
                   const std::function<bool(grpc::ByteBuffer&)>& take) {
    call_->outgoing = request;
    call_->stream->StartCall(as_pointer(started));
    bool taken = false;
    for (;;) {
      const auto event = next();
      if (!event) return event.error();
      if (!*event) return taken;
      if (**event == started) begin();
      if (**event != read) continue;
      taken = take(call_->incoming) || taken;
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
    return {Error{ErrorCode::internal, peer_ + " ended " + work_ + " without a result", {}, {}, {}},
            false, std::nullopt};
  }

 private:
  void begin() {
    call_->stream->WriteLast(call_->outgoing, grpc::WriteOptions(), as_pointer(wrote));
    call_->stream->Read(&call_->incoming, as_pointer(read));
  }

  // What has happened next; none at the end of the call, an error if the caller wants it to end.
  Result<std::optional<Tag>> next() {
    for (;;) {
      if (stop_ && stop_())
        return Error{ErrorCode::cancelled, work_ + " was cancelled", {}, {}, {}};
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

  std::string peer_, work_;
  const std::function<bool()>& stop_;
  OpenCallPointer call_;
  Clock::time_point late_ = call_->context.deadline() == Clock::time_point::max()
                                ? Clock::time_point::max()
                                : call_->context.deadline() + kGrace;
};

}  // namespace

Outcome call_with_progress(const Peer& peer, const ProgressMethod& method,
                           const grpc::ByteBuffer& request, Patience& patience,
                           const std::function<bool()>& stop,
                           const std::function<bool(grpc::ByteBuffer&)>& take) {
  for (;;) {
    Attempt attempt(peer, method, patience, stop);
    const auto taken = attempt.run(request, take);
    if (!taken) return taken.error();
    if (*taken) return Ok{};
    const Failure failure = attempt.failure();
    if (!patience.pause_to_retry(failure)) return failure.error;
  }
}

}  // namespace gonio::client
