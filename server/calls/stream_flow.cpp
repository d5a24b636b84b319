#include "server/calls/stream_flow.h"

#include <grpcpp/server_context.h>

#include <utility>

#include "server/calls/failure.h"

namespace gonio::server {
namespace {

grpc::Status over_too_early(bool late) noexcept {
  const auto code = late ? grpc::StatusCode::DEADLINE_EXCEEDED : grpc::StatusCode::CANCELLED;
  try {
    return {code, "the stream was over before all of its batches were answered"};
  } catch (...) {
    return {code, ""};  // no memory for more
  }
}

}  // namespace

StreamFlow::StreamFlow(const Backend& backend, grpc::CallbackServerContext& context,
                       const char* method, const char* name_of_items)
    : backend_(backend),
      state_(context.deadline()),
      access_(method, name_of_items, context, backend.logger) {}

void StreamFlow::begin() {
  happens_before(&state_);
  pump();
}

void StreamFlow::set_in_flight(std::size_t chunks) {
  const std::size_t before = std::exchange(in_flight_, chunks);
  if (before == 0 && chunks > 0) backend_.calls.begin();
  if (before > 0 && chunks == 0) backend_.calls.end();
}

void StreamFlow::OnReadDone(bool ok) {
  const Reaction reaction(this, &incoming_);
  if (!ok) return end_reading(grpc::Status::OK);
  grpc::Status taken;
  try {
    taken = take(incoming_);
    incoming_.Clear();
  } catch (...) {
    taken = status_of_failure(access_.method, std::current_exception(), backend_.logger);
  }
  if (!taken.ok()) return end_reading(std::move(taken));
  {
    const std::lock_guard lock(mutex_);
    reading_ = false;
  }
  pump();
}

void StreamFlow::end_reading(grpc::Status status) {
  {
    const std::lock_guard lock(mutex_);
    reading_ = false;
    reads_over_ = true;
    if (final_.ok()) final_ = std::move(status);
  }
  pump();
}

void StreamFlow::begin_chunk() {
  const std::lock_guard lock(mutex_);
  set_in_flight(in_flight_ + 1);
  ++access_.batches;
}

void StreamFlow::hold(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  held_bytes_ += bytes;
}

void StreamFlow::note_work(const Work& work, bool completed) {
  const std::lock_guard lock(mutex_);
  access_.items += work.items();
  access_.kernel_seconds += work.kernel_seconds();
  if (!completed) die();
}

void StreamFlow::note_failure() {
  const std::lock_guard lock(mutex_);
  ++access_.failed;
}

void StreamFlow::answer(Answer&& answer) noexcept {
  const std::size_t held_bytes = answer.held_bytes;
  try {
    pump(std::move(answer));
  } catch (...) {  // thrown before the answer was added
    lose(held_bytes);
  }
}

void StreamFlow::lose(std::size_t held_bytes) noexcept {
  {
    const std::lock_guard lock(mutex_);
    held_bytes_ -= held_bytes;
    set_in_flight(in_flight_ - 1);
    // So short that it needs no memory of its own.
    if (final_.ok()) final_ = {grpc::StatusCode::RESOURCE_EXHAUSTED, "out of memory"};
    dead_ = true;
  }
  pump();
}

void StreamFlow::OnWriteDone(bool ok) {
  const Reaction reaction(this, &writing_now_);
  {
    const std::lock_guard lock(mutex_);
    writing_ = false;
    set_in_flight(in_flight_ - 1);
    held_bytes_ -= writing_now_.held_bytes;
    writing_now_ = {};
    if (!ok) die();
  }
  pump();
}

void StreamFlow::OnCancel() {
  const Reaction reaction(this, &state_);
  state_.cancel();
  {
    const std::lock_guard lock(mutex_);
    die();
  }
  pump();
}

void StreamFlow::OnDone() {
  happens_after(this);
  const Backend& backend = backend_;
  delete this;
  backend.stream_ends();
}

// A stream that lost answers must not end as if it were complete.
void StreamFlow::die() {
  if (finished_) return;
  dead_ = true;
  if (final_.ok()) final_ = over_too_early(state_.past_deadline());
}

void StreamFlow::drop_answers() {
  for (const Answer& answer : ready_) held_bytes_ -= answer.held_bytes;
  set_in_flight(in_flight_ - ready_.size());
  ready_.clear();
}

StreamFlow::Next StreamFlow::next_steps(std::optional<Answer>& answer) {
  Next next;
  if (answer) ready_.push_back(std::move(*answer));  // the one step that may throw
  if (dead_) {
    drop_answers();
    reads_over_ = true;
  }
  if (!writing_ && !ready_.empty()) {
    writing_now_ = std::move(ready_.front());
    ready_.pop_front();
    writing_ = next.write = true;
  }
  const bool has_room = in_flight_ < kMaxInFlight && held_bytes_ <= backend_.max_message_bytes;
  if (!reading_ && !reads_over_ && has_room) reading_ = next.read = true;
  next.finish = !finished_ && reads_over_ && !reading_ && in_flight_ == 0;
  finished_ = finished_ || next.finish;
  if (next.finish) next.final = std::move(final_);
  return next;
}

// Starts whatever can be started: called after every event, a new answer being one. That is added
// under the same lock that decides on what follows: a compute thread holds no reference to the
// call, which may be over and deleted as soon as another thread finds the answer.
void StreamFlow::pump(std::optional<Answer> answer) {
  Next next;
  {
    const std::lock_guard lock(mutex_);
    next = next_steps(answer);
  }
  if (next.write) {
    happens_before(&writing_now_);
    StartWrite(&writing_now_.message);
  }
  if (next.read) {
    happens_before(&incoming_);
    StartRead(&incoming_);
  }
  if (!next.finish) return;
  access_.write(backend_.logger, next.final);
  happens_before(this);
  Finish(std::move(next.final));  // may delete this
}

}  // namespace gonio::server
