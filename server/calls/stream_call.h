// One streaming call, of which each chunk asks for work `W`: Evaluation or Sampling.
// Thread safety: see stream_flow.h; what belongs to reading (the slots) needs no lock.
#pragma once

#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <utility>

#include "server/calls/failure.h"
#include "server/calls/stream_flow.h"
#include "wire/codec.h"
#include "wire/status.h"

namespace gonio::server {

template <class W>
class StreamCall final : public StreamFlow {
 public:
  static StreamCall* start(const Backend& backend, grpc::CallbackServerContext& context) {
    auto* call = new StreamCall(backend, context);
    call->begin();
    return call;
  }

 private:
  using Chunk = wire::ChunkOf<typename W::Request>;
  static constexpr std::uint32_t kSlots = 256;

  StreamCall(const Backend& backend, grpc::CallbackServerContext& context)
      : StreamFlow(backend, context, W::kStreamMethod, W::kItems) {}

  grpc::Status take(const grpc::ByteBuffer& message) override;
  void handle(const Chunk& chunk);
  Result<PreparedMaterial> material_of(const Chunk& chunk);
  Result<std::shared_ptr<W>> prepare(const Chunk& chunk);
  void compute_chunk(std::uint64_t sequence, const std::shared_ptr<W>& work);
  void computed(std::uint64_t sequence, W& work, bool completed) noexcept;
  void refuse(std::uint64_t sequence, const Error& error, std::size_t held_bytes) noexcept;
  void fail(std::uint64_t sequence, const std::exception_ptr& failure,
            std::size_t held_bytes) noexcept;

  std::map<std::uint32_t, Result<PreparedMaterial>> slots_;
};

template <class W>
grpc::Status StreamCall<W>::take(const grpc::ByteBuffer& message) {
  const auto chunk = wire::decode<Chunk>(message);
  // Without a sequence number there is no way to say which chunk was wrong.
  if (!chunk) return wire::to_status(chunk.error());
  begin_chunk();
  handle(*chunk);
  return grpc::Status::OK;
}

// Answers the chunk or has it answered; throws nothing.
template <class W>
void StreamCall<W>::handle(const Chunk& chunk) {
  std::shared_ptr<W> work;
  try {
    auto prepared = prepare(chunk);
    if (!prepared) return refuse(chunk.sequence, prepared.error(), 0);
    work = std::move(*prepared);
  } catch (...) {
    return fail(chunk.sequence, std::current_exception(), 0);
  }
  hold(work->bytes());
  try {
    compute_chunk(chunk.sequence, work);
  } catch (...) {
    fail(chunk.sequence, std::current_exception(), work->bytes());
  }
}

template <class W>
void StreamCall<W>::compute_chunk(std::uint64_t sequence, const std::shared_ptr<W>& work) {
  WorkEnd end{[this, sequence, work](bool completed) { computed(sequence, *work, completed); },
              [this, sequence, work](const std::exception_ptr& failure) {
                fail(sequence, failure, work->bytes());
              }};
  const auto started = compute(backend(), work, state(), std::move(end));
  if (!started) refuse(sequence, started.error(), work->bytes());
}

// A bad material makes its slot bad too: later chunks must not be answered with the material before
// it.
template <class W>
Result<PreparedMaterial> StreamCall<W>::material_of(const Chunk& chunk) {
  if (chunk.slot >= kSlots) {
    return bad_value("slot", std::to_string(chunk.slot), "0 to " + std::to_string(kSlots - 1));
  }
  if (chunk.request && chunk.request->material) {
    auto material = backend().materials.resolve(chunk.request->material);
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
  return W::prepare(*chunk.request, std::move(*material), backend().max_message_bytes);
}

template <class W>
void StreamCall<W>::computed(std::uint64_t sequence, W& work, bool completed) noexcept {
  const std::size_t held_bytes = work.bytes();
  try {
    Answer made{{}, held_bytes, work.take_charge()};
    if (completed) made.message = wire::encode_stream_response(sequence, work.take_answer());
    note_work(work, completed);
    answer(std::move(made));
  } catch (...) {
    fail(sequence, std::current_exception(), held_bytes);
  }
}

template <class W>
void StreamCall<W>::refuse(std::uint64_t sequence, const Error& error,
                           std::size_t held_bytes) noexcept {
  try {
    note_failure();
    answer({wire::encode_stream_error(sequence, wire::to_detail(error)), held_bytes});
  } catch (...) {
    lose(held_bytes);
  }
}

template <class W>
void StreamCall<W>::fail(std::uint64_t sequence, const std::exception_ptr& failure,
                         std::size_t held_bytes) noexcept {
  refuse(sequence, error_of_failure(method(), failure, backend().logger), held_bytes);
}

}  // namespace gonio::server
