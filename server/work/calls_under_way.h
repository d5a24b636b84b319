// How many calls the server owes answers to: what its end waits for. Connections, and streams whose
// chunks are all answered, are none.
//
// Thread safety: any thread.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace gonio::server {

class CallsUnderWay {
 public:
  using Clock = std::chrono::steady_clock;

  void begin() {
    ++begun_;
    ++under_way_;
  }
  void end() { --under_way_; }

  // Returns once none has been under way for a moment, which the next chunk of a stream or the last
  // bytes of an answer may take; at `deadline` at the latest.
  void wait_for_none(Clock::time_point deadline);
  // Sleeps until `time`.
  void wait_until(Clock::time_point time);
  // From now on nothing is waited for.
  void hurry();

 private:
  std::atomic<std::uint64_t> begun_{0};
  std::atomic<int> under_way_{0};
  std::mutex mutex_;
  std::condition_variable hurried_;
  bool hurry_ = false;
};

}  // namespace gonio::server
