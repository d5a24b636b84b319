// One ThreadPool::run(): its tiles are shared among the calling thread and those that help it.
//
// Thread safety: drain() and end() may be called from any thread, the rest by the calling thread.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

#include "engine/threads/stay_alert.h"

namespace gonio {

class SharedRun {
 public:
  // `body` must outlive the run.
  SharedRun(const std::function<void(std::size_t)>& body, std::size_t tiles)
      : body_(body), tiles_(tiles) {}

  // Runs the tiles that no other thread has begun. If one throws, no further one is begun.
  void drain() {
    try {
      for (std::size_t i = next_.fetch_add(1); i < tiles_; i = next_.fetch_add(1)) body_(i);
    } catch (...) {
      next_ = tiles_;
      const auto lock = lock_soon(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  // Says that no helper is at work any more; wait() returns then.
  void end() {
    const auto lock = lock_soon(mutex_);
    done_ = true;
    finished_.notify_one();
  }
  void wait() {
    stay_alert([this] { return done_.load(); });
    std::unique_lock lock = lock_soon(mutex_);
    finished_.wait(lock, [this] { return done_.load(); });
  }

  // Throws what a tile threw first. No thread may be at work any more.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const std::function<void(std::size_t)>& body_;
  const std::size_t tiles_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::condition_variable finished_;
  std::atomic<bool> done_{false};  // set under the mutex
  std::exception_ptr failure_;     // guarded by the mutex while threads are at work
};

}  // namespace gonio
