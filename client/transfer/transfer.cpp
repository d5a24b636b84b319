#include "client/transfer/transfer.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "client/messages/convert.h"
#include "client/transfer/check_answer.h"
#include "wire/codec.h"
#include "wire/status.h"

namespace gonio::client {
namespace {

constexpr std::uint32_t kSlot = 0;  // one material a stream

}  // namespace

Transfer::Transfer(const Peer& peer, const ClientOptions& options, const RequestHead& head,
                   Patience& patience, ChunkSource& source, ChunkReceiver& receiver)
    : peer_(peer),
      head_(head),
      patience_(patience),
      source_(source),
      receiver_(receiver),
      in_flight_(static_cast<std::size_t>(options.in_flight)) {
  report_.precision = head_.precision();
}

std::string_view Transfer::head_for(const OutgoingChunk& chunk, bool with_material) {
  const auto head = with_material ? head_.with_material() : head_.without_material();
  if (chunk.head.empty()) return head;
  head_with_rest_ = head;
  head_with_rest_ += chunk.head;
  return head_with_rest_;
}

Outcome Transfer::run_call(std::size_t limit) {
  auto next = source_.next(limit);
  if (!next) return next.error();
  if (!*next) return Ok{};
  const OutgoingChunk& chunk = **next;
  const auto request = wire::encode_request(head_for(chunk, true), chunk.arrays);
  auto bytes = call(peer_, head_.method().call, request, patience_);
  if (!bytes) return bytes.error();
  auto answer = head_.method().decode(*bytes);
  if (!answer) return malformed(peer_, answer.error().message);
  return deliver(chunk, *answer);
}

Outcome Transfer::run_stream(std::size_t limit) {
  limit_ = limit;
  for (;;) {
    Stream stream(peer_, head_.method().stream, patience_);
    auto finished = run_one_stream(stream);
    if (!finished) return finished.error();
    if (*finished) return Ok{};
    const Failure failure = stream.failure();
    if (!patience_.pause_to_retry(failure)) return failure.error;
    send_again();
  }
}

Result<bool> Transfer::run_one_stream(Stream& stream) {
  bool with_material = true;
  for (;;) {
    if (stream.writable()) {
      auto sent = send_next(stream, with_material);
      if (!sent) return sent.error();
      if (!*sent && only_refused_left()) {
        if (!patience_.pause_to_retry(refusal_)) return refusal_.error;
        send_again();
        continue;
      }
    }
    if (done()) {
      stream.close();
      return true;
    }
    const Stream::Event event = stream.next();
    if (event == Stream::Event::ended) return false;
    if (event == Stream::Event::writable) continue;
    if (auto taken = take(stream.message()); !taken) return taken.error();
  }
}

Result<std::optional<std::uint64_t>> Transfer::choose_next() {
  std::size_t unanswered = 0;
  for (const auto& [sequence, pending] : pending_) {
    if (pending.state == State::to_send) return std::optional(sequence);
    if (pending.state != State::answered) ++unanswered;
  }
  // Answers that wait for their turn take memory too.
  const bool full = unanswered >= in_flight_ || pending_.size() >= 2 * in_flight_;
  if (at_end_ || full) return std::optional<std::uint64_t>{};
  auto next = source_.next(limit_);
  if (!next) return next.error();
  at_end_ = !next->has_value();
  if (at_end_) return std::optional<std::uint64_t>{};
  pending_[next_sequence_].chunk = std::move(**next);
  return std::optional(next_sequence_++);
}

Result<bool> Transfer::send_next(Stream& stream, bool& with_material) {
  auto sequence = choose_next();
  if (!sequence) return sequence.error();
  if (!*sequence) return false;
  Pending& pending = pending_.at(**sequence);
  const auto head = head_for(pending.chunk, with_material);
  stream.write(wire::encode_stream_request(**sequence, kSlot, head, pending.chunk.arrays));
  pending.state = State::on_its_way;
  with_material = false;
  return true;
}

// One full queue refuses all the chunks that come to it: only when the last of them is back is it
// time to pause, once for all.
bool Transfer::only_refused_left() const {
  const auto on_its_way = [](const auto& one) { return one.second.state == State::on_its_way; };
  return !pending_.empty() && std::ranges::none_of(pending_, on_its_way);
}

// An answer leaves room for another chunk in the server's queue.
void Transfer::send_one_refused_again() {
  for (auto& [sequence, pending] : pending_) {
    if (pending.state == State::refused) return void(pending.state = State::to_send);
  }
}

void Transfer::send_again() {
  for (auto& [sequence, pending] : pending_) {
    if (pending.state != State::answered) pending.state = State::to_send;
  }
}

Outcome Transfer::take(const grpc::ByteBuffer& message) {
  auto response = head_.method().decode_stream(message);
  if (!response) return malformed(peer_, response.error().message);
  const auto found = pending_.find(response->sequence);
  if (found == pending_.end() || found->second.state != State::on_its_way) {
    return malformed(
        peer_, "sequence number " + std::to_string(response->sequence) + ", which is not awaited");
  }
  if (const auto* detail = std::get_if<gonio::v1::ErrorDetail>(&response->result)) {
    return take_error(response->sequence, *detail);
  }
  patience_.progress();
  send_one_refused_again();
  return take_answer(response->sequence, std::get<Answer>(std::move(response->result)));
}

Outcome Transfer::take_error(std::uint64_t sequence, const gonio::v1::ErrorDetail& detail) {
  refusal_ = failure_of(detail);
  if (!refusal_.may_retry) return refusal_.error;
  pending_.at(sequence).state = State::refused;
  return Ok{};
}

Outcome Transfer::take_answer(std::uint64_t sequence, Answer answer) {
  if (!receiver_.ordered()) {
    auto taken = pending_.extract(sequence);
    return deliver(taken.mapped().chunk, answer);
  }
  Pending& answered = pending_.at(sequence);
  answered.state = State::answered;
  answered.answer = std::move(answer);
  while (!pending_.empty() && pending_.begin()->second.state == State::answered) {
    auto taken = pending_.extract(pending_.begin());
    if (auto delivered = deliver(taken.mapped().chunk, taken.mapped().answer); !delivered) {
      return delivered;
    }
  }
  return Ok{};
}

Outcome Transfer::deliver(const OutgoingChunk& chunk, const Answer& answer) {
  if (auto fit = check_lengths(peer_, head_, chunk, answer, report_.channels); !fit) return fit;
  const gonio::v1::Report& cost = answer.report;
  if (report_.channels == 0) {
    report_.channels = static_cast<int>(answer.channels);
    report_.instruction_set = instruction_set_of(cost.instruction_set());
    report_.error_bound = error_bound_of(cost.error_bound());
  }
  report_.pairs += chunk.pairs;
  report_.lost += answer.lost;
  report_.kernel_seconds += cost.kernel_seconds();
  report_.retries = patience_.retries();
  return receiver_.accept(chunk, answer, report_);
}

}  // namespace gonio::client
