#include "server/calls/progress_call.h"

#include <grpcpp/server_context.h>

#include <functional>

#include "base/happens_before.h"
#include "wire/status.h"

namespace gonio::server {
namespace {

using Clock = std::chrono::system_clock;

constexpr std::chrono::milliseconds kInterval{200};  // of progress

// The name of what gRPC guarantees of alarms: it calls back, and lets go, after Set(). Not the
// call's own, which a callback does not know to be there.
const char kAlarms = 0;

}  // namespace

ProgressCall::ProgressCall(const Backend& backend, grpc::CallbackServerContext& context,
                           const char* method, const char* work)
    : background_(backend, context, method, work) {}

ProgressCall::~ProgressCall() { happens_after(&kAlarms); }

void ProgressCall::begin(const grpc::ByteBuffer& request) {
  self_ = shared_from_this();
  happens_before(background_.state());
  try {
    if (const auto queued = enqueue(request); !queued) return fail(wire::to_status(queued.error()));
  } catch (...) {
    return fail(background_.status_of(std::current_exception()));
  }
  tick();
}

Outcome ProgressCall::enqueue(const grpc::ByteBuffer& request) {
  const auto bytes = prepare(request);
  if (!bytes) return bytes.error();
  const auto self = shared_from_this();
  return background_.submit(
      *bytes, [self] { self->run(); },
      [self](grpc::Status status) { self->fail(std::move(status)); });
}

void ProgressCall::run() {
  if (background_.is_over()) return fail(wire::to_status(background_.over()));
  auto result = work();
  if (!result) return fail(wire::to_status(background_.error_of(result.error())));
  end(std::move(*result), grpc::Status::OK);
}

void ProgressCall::note(grpc::ByteBuffer progress) {
  const std::lock_guard lock(mutex_);
  progress_.Swap(&progress);
}

// NOLINTNEXTLINE(bugprone-exception-escape): see its declaration
void ProgressCall::end(std::optional<grpc::ByteBuffer> result, grpc::Status status) noexcept {
  background_.ended(status);
  {
    const std::lock_guard lock(mutex_);
    if (end_) return;
    result_ = std::move(result);
    end_ = std::move(status);
  }
  pump(false);
}

// Now, and again and again until the call is over.
void ProgressCall::tick() {
  {
    const std::lock_guard lock(mutex_);
    if (end_) return;
  }
  pump(true);
  try {
    set_alarm();
  } catch (...) {
    // There is no memory for it: no progress is sent from now on, and the result as ever.
  }
}

void ProgressCall::set_alarm() {
  // Weak: the alarm belongs to the call.
  std::function<void(bool)> again = [weak = weak_from_this()](bool) {
    happens_after(&kAlarms);
    if (const auto call = weak.lock()) call->tick();
  };
  happens_before(&kAlarms);
  alarm_.Set(Clock::now() + kInterval, std::move(again));
}

void ProgressCall::OnWriteDone(bool ok) {
  const Reaction reaction(this, &outgoing_);
  {
    const std::lock_guard lock(mutex_);
    writing_ = false;
  }
  if (!ok) background_.stop_writing();
  pump(false);
}

void ProgressCall::OnCancel() {
  const Reaction reaction(this, background_.state());
  background_.cancel();
}

void ProgressCall::OnDone() {
  happens_after(this);
  const Backend& backend = background_.backend();
  self_.reset();
  backend.call_ends();
}

// One write at a time; the result goes with the end.
void ProgressCall::pump(bool progress_is_due) {
  const auto self = shared_from_this();  // gRPC may be done with the call before this returns
  bool write = false;
  std::optional<grpc::Status> final;
  {
    const std::lock_guard lock(mutex_);
    if (writing_ || finished_) return;
    if (end_) {
      finished_ = true;
      final = std::move(end_);  // leaves end_ set
      if (result_) outgoing_.Swap(&*result_);
      write = result_.has_value();
    } else if (progress_is_due) {
      outgoing_ = progress_;
      writing_ = write = true;
    }
  }
  happens_before(&outgoing_);
  if (final) happens_before(this);
  if (final && write) return StartWriteAndFinish(&outgoing_, {}, std::move(*final));
  if (final) return Finish(std::move(*final));
  if (write) StartWrite(&outgoing_);
}

}  // namespace gonio::server
