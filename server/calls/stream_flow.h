// The flow of a stream of chunks, whatever the chunks ask for: it reads chunks, keeps a few of
// them in flight, and writes the answers as they get ready.
//
// Made with new, it deletes itself when gRPC is done with it. Reads are one at a time; what several
// threads use is guarded by mutex_, which is never held while gRPC is called.
#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <deque>
#include <exception>
#include <mutex>
#include <optional>

#include "server/calls/call.h"

// Instantiated once, in service.cpp.
extern template class grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>;

namespace gonio::server {

class StreamFlow : public grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer> {
 public:
  ~StreamFlow() override = default;

  // Begins to read. Not for constructors: chunks are handled from then on.
  void begin();

 protected:
  struct Answer {
    grpc::ByteBuffer message;
    std::size_t held_bytes = 0;  // given back when it is written
    MemoryBudget::Charge charge = {};
  };

  StreamFlow(const Backend& backend, grpc::CallbackServerContext& context, const char* method,
             const char* name_of_items);

  // A message that has been read. Each begin_chunk() needs one answer() or lose(), then or later.
  // An error ends the stream once the chunks in flight are answered, as what is thrown does.
  virtual grpc::Status take(const grpc::ByteBuffer& message) = 0;

  void begin_chunk();
  void hold(std::size_t bytes);  // the memory of a chunk in flight
  // Counts what a chunk's work has done. Of one that was not completed the stream ends: it could
  // not be answered as if it were complete.
  void note_work(const Work& work, bool completed);
  void note_failure();
  // May be the last that is done with the stream: it may be over and deleted on return.
  void answer(Answer&& answer) noexcept;
  // In place of an answer that cannot be made, for want of memory: the stream ends.
  void lose(std::size_t held_bytes) noexcept;

  [[nodiscard]] const Backend& backend() const { return backend_; }
  [[nodiscard]] const CallState& state() const { return state_; }
  [[nodiscard]] const char* method() const { return access_.method; }

 private:
  // More chunks than this are left with gRPC, whose flow control then holds the client back.
  static constexpr std::size_t kMaxInFlight = 8;

  // The operations to ask gRPC for, decided under the lock.
  struct Next {
    bool read = false, write = false, finish = false;
    grpc::Status final;
  };

  void OnReadDone(bool ok) override;
  void OnWriteDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

  void end_reading(grpc::Status status);
  void pump(std::optional<Answer> answer = std::nullopt);
  Next next_steps(std::optional<Answer>& answer);  // mutex_ is held
  void set_in_flight(std::size_t chunks);          // mutex_ is held
  void die();                                      // mutex_ is held
  void drop_answers();                             // mutex_ is held

  const Backend& backend_;
  CallState state_;
  AccessLine access_;
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
