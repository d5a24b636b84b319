// One bidirectional stream of raw messages, driven by the calling thread. Internal to the client
// library.
//
// next() does the work: it polls the connection and says what has happened. At most one write and
// one read are under way at a time; a read always is until the stream has ended. Thread safety:
// used by one thread.
#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>

#include <cstdint>
#include <memory>
#include <string>

#include "client/retry.h"
#include "client/rpc.h"

namespace gonio::client {

class Stream {
 public:
  Stream(const Peer& peer, const Patience& patience);
  ~Stream();  // cancels what is still under way
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  enum class Event : std::uint8_t {
    writable,  // started, or the last write is done
    message,   // message() has come
    ended,     // there will be nothing more
  };
  Event next();

  [[nodiscard]] bool writable() const { return writable_; }
  void write(grpc::ByteBuffer message);  // only when writable()
  // The one that has come, until the next call of next().
  [[nodiscard]] const grpc::ByteBuffer& message() const { return message_; }

  // Says that nothing more is written and waits for the status of a stream that has answered
  // everything.
  void close();
  // Why a stream ended; after Event::ended.
  Failure failure();

 private:
  enum Tag : std::intptr_t { started = 1, wrote, read, closed, finished };
  static void* as_tag(Tag tag) { return reinterpret_cast<void*>(static_cast<std::intptr_t>(tag)); }
  void start_read();
  void drain();

  std::string peer_;
  grpc::ClientContext context_;
  grpc::CompletionQueue queue_;
  std::unique_ptr<grpc::GenericClientAsyncReaderWriter> rpc_;
  grpc::ByteBuffer outgoing_, incoming_, message_;
  bool writable_ = false;
};

}  // namespace gonio::client
