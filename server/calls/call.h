// What the handlers share: the parts of the server they work with, and how work gets onto the
// compute pool.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <string>

#include "base/happens_before.h"
#include "gonio/base/result.h"
#include "gonio/engine/thread_pool.h"
#include "server/materials/materials.h"
#include "server/work/background_queue.h"
#include "server/work/calls_under_way.h"
#include "server/work/memory_budget.h"
#include "server/work/work.h"

namespace grpc {
class CallbackServerContext;
class Status;
}  // namespace grpc
namespace spdlog {
class logger;
}

namespace gonio::server {

// Where fits run, and for how long one may.
struct FitBackend {
  BackgroundQueue& queue;
  std::chrono::milliseconds longest;
  bool give_way = true;  // to evaluation
};

// References to what outlives every call. Thread safety: all of it may be used from any thread.
struct Backend {
  Materials& materials;
  ThreadPool& pool;
  std::size_t max_message_bytes;
  std::size_t max_queued_jobs;
  spdlog::logger& logger;
  MemoryBudget& memory;
  FitBackend fits;
  BackgroundQueue& puts;  // where uploads are checked and stored
  CallsUnderWay& calls;

  // gRPC makes calls after a server's start, and ends its shutdown after the last of them: what was
  // done with the backend before server_begins() is over at call_begins(), and what a call did
  // before call_ends() is over at server_ended().
  void server_begins() const { happens_before(&materials); }
  void call_begins() const {
    calls.begin();
    stream_begins();
  }
  void call_ends() const {
    stream_ends();
    calls.end();
  }
  // Of a stream, which is under way only while it owes answers.
  void stream_begins() const { happens_after(&materials); }
  void stream_ends() const { happens_before(&memory); }
  void server_ended() const { happens_after(&memory); }
};

// The time of one reaction of a call. gRPC begins it after what it is the reaction to, an operation
// or the call's beginning, and ends it before OnDone().
class Reaction {
 public:
  Reaction(const void* call, const void* cause) : call_(call) { happens_after(cause); }
  ~Reaction() { happens_before(call_); }
  Reaction(const Reaction&) = delete;
  Reaction& operator=(const Reaction&) = delete;

 private:
  const void* call_;
};

// Whether a call's result is still wanted. Thread safety: any thread.
class CallState {
 public:
  explicit CallState(std::chrono::system_clock::time_point deadline) : deadline_(deadline) {}
  void cancel() { cancelled_ = true; }
  [[nodiscard]] bool is_over() const { return cancelled_ || past_deadline(); }
  [[nodiscard]] bool past_deadline() const { return std::chrono::system_clock::now() >= deadline_; }

 private:
  std::atomic<bool> cancelled_{false};
  std::chrono::system_clock::time_point deadline_;
};

// How a call learns of the end of its work, once and from any thread. Neither may throw.
struct WorkEnd {
  std::function<void(bool completed)> done;
  std::function<void(const std::exception_ptr& failure)> failed;  // the work threw
};

// Does small work at once and queues the other; one of `end` is called exactly once, here or by a
// compute thread, unless the queue or the memory is full: then the error says so and neither is
// called, as when this throws. The work's memory is charged for as long as its charge is kept. The
// call is asked before each tile whether it is over; `state` must live until the end.
Outcome compute(const Backend& backend, const std::shared_ptr<Work>& work, const CallState& state,
                WorkEnd end);

// How long a client that was refused for this should wait: some jobs are done by then.
inline constexpr const char* kPushbackMilliseconds = "20";
inline constexpr const char* kFitPushbackMilliseconds = "1000";

// One line a call, at level debug.
struct AccessLine {
  const char* method;
  const char* items_name;  // "pairs"
  std::string peer;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::size_t batches = 0, failed = 0, items = 0;
  double kernel_seconds = 0;

  AccessLine(const char* method_name, const char* name_of_items,
             const grpc::CallbackServerContext& context, const spdlog::logger& logger);
  // A line that cannot be written is left out: the call ends all the same.
  void write(spdlog::logger& logger, const grpc::Status& status) const noexcept;
};

}  // namespace gonio::server
