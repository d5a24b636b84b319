#include "server/calls/stream_call.h"

#include <grpcpp/server_context.h>

#include <utility>

#include "server/work/evaluation.h"
#include "server/work/sampling.h"
#include "wire/codec.h"
#include "wire/status.h"

namespace gonio::server {
namespace {

constexpr std::uint32_t kSlots = 256;

}  // namespace

template <class W>
StreamCall<W>::StreamCall(const Backend& backend, grpc::CallbackServerContext& context)
    : backend_(backend),
      state_(context.deadline()),
      access_(W::kStreamMethod, W::kItems, context, backend.logger) {
  happens_before(&state_);
  pump();
}

template <class W>
void StreamCall<W>::set_in_flight(std::size_t chunks) {
  const std::size_t before = std::exchange(in_flight_, chunks);
  if (before == 0 && chunks > 0) backend_.calls.begin();
  if (before > 0 && chunks == 0) backend_.calls.end();
}

template <class W>
void StreamCall<W>::OnReadDone(bool ok) {
  const Reaction reaction(this, &incoming_);
  if (!ok) return end_reading(grpc::Status::OK);
  auto chunk = wire::decode<Chunk>(incoming_);
  incoming_.Clear();
  // Without a sequence number there is no way to say which chunk was wrong.
  if (!chunk) return end_reading(wire::to_status(chunk.error()));
  {
    const std::lock_guard lock(mutex_);
    set_in_flight(in_flight_ + 1);
    ++access_.batches;
  }
  handle(*chunk);
  {
    const std::lock_guard lock(mutex_);
    reading_ = false;
  }
  pump();
}

template <class W>
void StreamCall<W>::end_reading(const grpc::Status& status) {
  {
    const std::lock_guard lock(mutex_);
    reading_ = false;
    reads_over_ = true;
    if (final_.ok()) final_ = status;
  }
  pump();
}

template <class W>
void StreamCall<W>::handle(const Chunk& chunk) {
  const auto prepared = prepare(chunk);
  if (!prepared) return refuse(chunk.sequence, prepared.error(), 0);
  const std::size_t bytes = (*prepared)->bytes();
  {
    const std::lock_guard lock(mutex_);
    held_bytes_ += bytes;
  }
  const auto done = [this, sequence = chunk.sequence, work = *prepared, bytes](bool completed) {
    computed(sequence, *work, bytes, completed);
  };
  const auto started = compute(backend_, *prepared, state_, done);
  if (!started) refuse(chunk.sequence, started.error(), bytes);
}

// A bad material makes its slot bad too: later chunks must not be answered with the material before
// it.
template <class W>
Result<PreparedMaterial> StreamCall<W>::material_of(const Chunk& chunk) {
  if (chunk.slot >= kSlots) {
    return bad_value("slot", std::to_string(chunk.slot), "0 to " + std::to_string(kSlots - 1));
  }
  if (chunk.request && chunk.request->material) {
    auto material = backend_.materials.resolve(chunk.request->material);
    // Kept as long as the stream: no more of it than will be sent.
    if (!material) material = wire::from_detail(wire::to_detail(material.error()));
    return slots_.insert_or_assign(chunk.slot, material).first->second;
  }
  const auto known = slots_.find(chunk.slot);
  if (known != slots_.end()) return known->second;
  return bad_value("material", "not given, and slot " + std::to_string(chunk.slot) + " holds none",
                   "a material with the first chunk of each slot");
}

template <class W>
Result<std::shared_ptr<W>> StreamCall<W>::prepare(const Chunk& chunk) {
  if (!chunk.request) return chunk.request.error();
  auto material = material_of(chunk);
  if (!material) return material.error();
  return W::prepare(*chunk.request, std::move(*material), backend_.max_message_bytes);
}

template <class W>
void StreamCall<W>::computed(std::uint64_t sequence, W& work, std::size_t held_bytes,
                             bool completed) {
  Answer answer{{}, held_bytes, work.take_charge()};
  if (completed) answer.message = wire::encode_stream_response(sequence, work.take_answer());
  {
    const std::lock_guard lock(mutex_);
    access_.items += work.items();
    access_.kernel_seconds += work.kernel_seconds();
    if (!completed) die();
  }
  pump(std::move(answer));
}

template <class W>
void StreamCall<W>::refuse(std::uint64_t sequence, const Error& error, std::size_t held_bytes) {
  {
    const std::lock_guard lock(mutex_);
    ++access_.failed;
  }
  pump(Answer{wire::encode_stream_error(sequence, wire::to_detail(error)), held_bytes});
}

template <class W>
void StreamCall<W>::OnWriteDone(bool ok) {
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

template <class W>
void StreamCall<W>::OnCancel() {
  const Reaction reaction(this, &state_);
  state_.cancel();
  {
    const std::lock_guard lock(mutex_);
    die();
  }
  pump();
}

template <class W>
void StreamCall<W>::OnDone() {
  happens_after(this);
  const Backend& backend = backend_;
  delete this;
  backend.stream_ends();
}

// A stream that lost answers must not end as if it were complete.
template <class W>
void StreamCall<W>::die() {
  if (finished_) return;
  dead_ = true;
  if (!final_.ok()) return;
  const bool late = state_.past_deadline();
  final_ = {late ? grpc::StatusCode::DEADLINE_EXCEEDED : grpc::StatusCode::CANCELLED,
            "the stream was over before all of its batches were answered"};
}

template <class W>
void StreamCall<W>::drop_answers() {
  for (const Answer& answer : ready_) held_bytes_ -= answer.held_bytes;
  set_in_flight(in_flight_ - ready_.size());
  ready_.clear();
}

// Starts whatever can be started: called after every event, a new answer being one. That is added
// under the same lock that decides on what follows: a compute thread holds no reference to the
// call, which may be over and deleted as soon as another thread finds the answer.
template <class W>
void StreamCall<W>::pump(std::optional<Answer> answer) {
  bool read = false, write = false, finish = false;
  grpc::Status final;
  {
    const std::lock_guard lock(mutex_);
    if (answer) ready_.push_back(std::move(*answer));
    if (dead_) {
      drop_answers();
      reads_over_ = true;
    }
    if (!writing_ && !ready_.empty()) {
      writing_now_ = std::move(ready_.front());
      ready_.pop_front();
      writing_ = write = true;
    }
    const bool has_room = in_flight_ < kMaxInFlight && held_bytes_ <= backend_.max_message_bytes;
    if (!reading_ && !reads_over_ && has_room) reading_ = read = true;
    finish = !finished_ && reads_over_ && !reading_ && in_flight_ == 0;
    finished_ = finished_ || finish;
    if (finish) final = final_;
  }
  if (write) {
    happens_before(&writing_now_);
    StartWrite(&writing_now_.message);
  }
  if (read) {
    happens_before(&incoming_);
    StartRead(&incoming_);
  }
  if (!finish) return;
  access_.write(backend_.logger, final.ok() ? "OK" : final.error_message());
  happens_before(this);
  Finish(final);  // may delete this
}

template class StreamCall<Evaluation>;
template class StreamCall<Sampling>;

}  // namespace gonio::server
