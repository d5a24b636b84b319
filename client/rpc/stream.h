// One bidirectional stream of raw messages, driven by the calling thread. Internal to the client
// library.
//
// next() does the work: it polls the connection and says what has happened. At most one write and
// one read are under way at a time; a read always is until the stream has ended. Thread safety:
// used by one thread.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <cstdint>
#include <string>

#include "client/rpc/open_call.h"
#include "client/rpc/retry.h"
#include "client/rpc/rpc.h"

namespace gonio::client {

class Stream {
 public:
  Stream(const Peer& peer, const char* method, const Patience& patience);

  enum class Event : std::uint8_t {
    writable,  // started, or the last write is done
    message,   // message() has come
    ended,     // there will be nothing more
  };
  Event next();

  [[nodiscard]] bool writable() const { return writable_; }
  void write(const grpc::ByteBuffer& message);  // only when writable()
  // The one that has come, until the next call of next().
  [[nodiscard]] const grpc::ByteBuffer& message() const { return message_; }

  // Says that nothing more is written and waits for the end of a stream that has answered
  // everything.
  void close();
  // Why a stream ended; after Event::ended.
  Failure failure();

 private:
  void start_read();

  std::string peer_;
  OpenCallPointer call_;
  grpc::ByteBuffer message_;
  bool writable_ = false;
};

}  // namespace gonio::client
