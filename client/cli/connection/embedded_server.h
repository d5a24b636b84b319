// The server inside a command's own process: the object that goniod runs. Only this class knows
// server/server.h. Thread safety: used by one thread.
#pragma once

#include <memory>
#include <string>

#include "gonio/base/result.h"

namespace grpc {
class Channel;
}

namespace gonio::cli {

class EmbeddedServer {
 public:
  // `threads`: compute threads; 0 for one per processor.
  // Reached by channel() alone. It is private to this user: requests may name files of this
  // machine.
  static Result<EmbeddedServer> start(int threads);
  // Reached at a socket, with a server's usual limits: for measuring what the wire costs.
  static Result<EmbeddedServer> start_at(const std::string& address, int threads);

  EmbeddedServer(EmbeddedServer&&) noexcept;
  EmbeddedServer& operator=(EmbeddedServer&&) noexcept;
  ~EmbeddedServer();

  // A channel without a socket.
  [[nodiscard]] std::shared_ptr<grpc::Channel> channel() const;

 private:
  struct State;
  explicit EmbeddedServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace gonio::cli
