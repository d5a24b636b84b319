// Sends the chunks of an evaluation or of a drawing of samples, and takes their answers, over one
// unary call or over streams. Internal to the client library.
//
// Chunks are numbered. Answers are matched by number and may come in any order. A chunk is kept
// until it is answered: when a stream breaks, it is sent again on the next one. Thread safety: used
// by one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "client/messages/request_head.h"
#include "client/rpc/retry.h"
#include "client/rpc/rpc.h"
#include "client/rpc/stream.h"
#include "client/transfer/chunk.h"
#include "gonio/base/result.h"

namespace gonio::client {

class Transfer {
 public:
  // All of these outlive the transfer.
  Transfer(const Peer& peer, const ClientOptions& options, const RequestHead& head,
           Patience& patience, ChunkSource& source, ChunkReceiver& receiver);

  // Everything in one unary call; `limit` is at least the number of pairs.
  Outcome run_call(std::size_t limit);
  // Everything over streams, at most `limit` pairs a chunk.
  Outcome run_stream(std::size_t limit);

  [[nodiscard]] const Report& report() const { return report_; }

 private:
  enum class State : std::uint8_t {
    to_send,
    on_its_way,
    refused,   // by a server that was too busy; sent again later
    answered,  // held back until its turn
  };
  struct Pending {
    OutgoingChunk chunk;
    State state = State::to_send;
    Answer answer;
  };

  Result<bool> run_one_stream(Stream& stream);                  // false: the stream broke
  Result<bool> send_next(Stream& stream, bool& with_material);  // false: nothing to send
  Result<std::optional<std::uint64_t>> choose_next();
  std::string_view head_for(const OutgoingChunk& chunk, bool with_material);
  Outcome take(const grpc::ByteBuffer& message);
  Outcome take_answer(std::uint64_t sequence, Answer answer);
  Outcome take_error(std::uint64_t sequence, const gonio::v1::ErrorDetail& detail);
  Outcome deliver(const OutgoingChunk& chunk, const Answer& answer);
  [[nodiscard]] bool only_refused_left() const;
  void send_one_refused_again();
  void send_again();
  [[nodiscard]] bool done() const { return at_end_ && pending_.empty(); }

  const Peer& peer_;
  const RequestHead& head_;
  std::string head_with_rest_;
  Patience& patience_;
  ChunkSource& source_;
  ChunkReceiver& receiver_;
  Report report_;
  std::size_t in_flight_;
  std::size_t limit_ = 0;
  std::map<std::uint64_t, Pending> pending_;  // by sequence number; not yet delivered
  std::uint64_t next_sequence_ = 0;
  Failure refusal_;  // the latest
  bool at_end_ = false;
};

}  // namespace gonio::client
