// One streaming call, of which each chunk asks for work `W` (Evaluation or Sampling): reads chunks,
// keeps a few of them in flight, writes the answers as they get ready.
//
// Made with new, it deletes itself when gRPC is done with it. Reads are one at a time, so what
// belongs to reading (the slots) needs no lock; the rest is guarded by mutex_, which is never held
// while gRPC is called.
#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "server/calls/call.h"
#include "wire/codec.h"

// Instantiated once, in service.cpp.
extern template class grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>;

namespace gonio::server {

template <class W>
class StreamCall final : public grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer> {
 public:
  StreamCall(const Backend& backend, grpc::CallbackServerContext& context);

 private:
  using Chunk = wire::ChunkOf<typename W::Request>;

  // More chunks than this are left with gRPC, whose flow control then holds the client back.
  static constexpr std::size_t kMaxInFlight = 8;

  struct Answer {
    grpc::ByteBuffer message;
    std::size_t held_bytes = 0;  // given back when it is written
    MemoryBudget::Charge charge = {};
  };

  void OnReadDone(bool ok) override;
  void OnWriteDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

  void end_reading(const grpc::Status& status);
  void handle(const Chunk& chunk);
  Result<PreparedMaterial> material_of(const Chunk& chunk);
  Result<std::shared_ptr<W>> prepare(const Chunk& chunk);
  void computed(std::uint64_t sequence, W& work, std::size_t held_bytes, bool completed);
  void refuse(std::uint64_t sequence, const Error& error, std::size_t held_bytes);
  void pump(std::optional<Answer> answer = std::nullopt);
  void set_in_flight(std::size_t chunks);  // mutex_ is held
  void die();                              // mutex_ is held
  void drop_answers();                     // mutex_ is held

  const Backend& backend_;
  CallState state_;
  AccessLine access_;
  std::map<std::uint32_t, Result<PreparedMaterial>> slots_;
  grpc::ByteBuffer incoming_;

  std::mutex mutex_;
  std::deque<Answer> ready_;
  Answer writing_now_;
  std::size_t in_flight_ = 0;   // chunks read whose answers are not yet written
  std::size_t held_bytes_ = 0;  // of those
  bool reading_ = false;
  bool reads_over_ = false;
  bool writing_ = false;
  bool dead_ = false;  // cancelled or disconnected: nothing can be written any more
  bool finished_ = false;
  grpc::Status final_;
};

}  // namespace gonio::server
