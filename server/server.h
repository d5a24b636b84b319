// The gonio server object: goniod runs one, and the command line holds one inside its own process.
//
// Thread safety: shutdown() and wait() may be called from any thread, the rest after start() from
// any thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gonio/base/result.h"

namespace grpc {
class Channel;
}
namespace spdlog {
class logger;
}

namespace gonio::server {

struct ServerOptions {
  // The most compute threads, and the most threads for fits.
  static constexpr int kMostThreads = 1024;

  // Each "host:port" (port 0 takes a free one), "[::1]:port" or "unix:PATH". Empty: reached
  // in-process only.
  std::vector<std::string> addresses = {};
  // Of the UNIX sockets, from their first moment on, whatever the process's umask; none: what that
  // leaves.
  std::optional<unsigned> socket_mode = {};
  // Compute threads, up to kMostThreads; 0 means one per processor.
  int threads = 0;
  // Batches queued or being computed at a time; one more is refused with RESOURCE_EXHAUSTED.
  std::size_t max_queued_jobs = 256;
  // The largest message received or sent.
  std::size_t max_message_bytes = std::size_t{64} << 20;
  // What the requests and answers under way may hold, all calls together (one more is refused with
  // RESOURCE_EXHAUSTED), and what gRPC may hold in buffers beside them.
  std::size_t memory_quota_bytes = std::size_t{1} << 30;
  // Every *.json and *.binary in it that can be used is served under its stem; empty for none.
  std::filesystem::path materials = {};
  // What materials that clients put may hold, all together since the start; one more is refused.
  // They go into the `materials` folder if there is one that can be written to, else into memory.
  // 0: none are taken.
  std::size_t put_quota_bytes = std::size_t{1} << 30;
  // Lets a request name a file of this machine: {"model": "measured", "parameters": {"file":
  // "x.binary"}}. Only for a server that is private to one user.
  bool allow_local_files = false;
  // How long shutdown() goes on serving while it already reports NOT_SERVING, so that balancers
  // look elsewhere.
  std::chrono::milliseconds lame_duck{0};
  // Threads for fits, beside the compute threads and at the lowest priority; fits that wait or run
  // at a time (one more is refused with RESOURCE_EXHAUSTED); how long one may take, waiting
  // included.
  int fit_threads = 2;
  std::size_t max_fits = 16;
  std::chrono::milliseconds longest_fit = std::chrono::minutes(10);
  // At the lowest priority, so that evaluation does not wait for them. A process that does one
  // thing at a time has nothing to gain by it, and on a busy machine much to lose.
  bool fits_give_way = true;
  // Null: no log.
  std::shared_ptr<spdlog::logger> logger = nullptr;
};

class Server {
 public:
  // Errors name what is wrong: an option (invalid_argument), an address that cannot be listened on,
  // a materials folder. A file in that which cannot be used is not served; the log says so.
  static Result<std::unique_ptr<Server>> start(const ServerOptions& options);

  // Looks at what start() would, and listens nowhere. Errors: also files that would not be served,
  // each of which the log names.
  static Outcome check(const ServerOptions& options);

  ~Server();  // shutdown() without grace, if that was not called
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // A channel to this server that uses no socket. No call may be made on it once shutdown() has
  // begun: unlike a real connection's, gRPC's in-process transport does not survive it.
  [[nodiscard]] std::shared_ptr<grpc::Channel> in_process_channel();

  // The port of the first TCP address (the one chosen, where 0 was asked for); 0 if there is none.
  [[nodiscard]] int port() const;

  // Reports NOT_SERVING, serves for the lame duck, then takes no new calls and waits up to `grace`
  // for those under way before cancelling them. A stream is under way while answers are owed to it;
  // connections and streams without any are not waited for. Returns when all is over, also where
  // another call has begun it.
  void shutdown(std::chrono::milliseconds grace);

  // Lets a shutdown wait no longer: neither for the lame duck nor for calls.
  void hurry();

  // Returns when the server has been shut down.
  void wait();

 private:
  struct State;
  explicit Server(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace gonio::server
