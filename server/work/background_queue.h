// Threads for work that takes seconds, apart from those that evaluate.
//
// A fit, an assessment or the storing of an uploaded material never runs where it could hold up an
// evaluation: neither on gRPC's threads nor on the compute pool, and at the lowest priority that
// the system has for what still gets on. Thread safety: any thread.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace gonio::server {

class BackgroundQueue {
 public:
  struct Job {
    std::function<void()> run;      // called exactly once, if the job was taken
    std::function<bool()> is_over;  // nobody waits for it any more: run() then costs nothing
    // Called where run() throws, on the same thread, which then goes on. Must not throw.
    std::function<void(const std::exception_ptr& failure)> failed = {};
  };

  // At most `max_jobs` wait or run at a time. `lowest`: at the lowest priority.
  BackgroundQueue(int threads, std::size_t max_jobs, bool lowest = true);
  ~BackgroundQueue();  // runs what is still queued
  BackgroundQueue(const BackgroundQueue&) = delete;
  BackgroundQueue& operator=(const BackgroundQueue&) = delete;

  [[nodiscard]] std::size_t max_jobs() const { return max_jobs_; }
  // False if the queue is full.
  [[nodiscard]] bool submit(Job job);
  // A job calls this every fraction of a millisecond. At the lowest priority it still keeps a
  // processor to the end of a tick (4 ms) from an evaluation that has just been woken: that was
  // five times the 99th percentile of a chunk, and is 1.2 to 1.9 with this
  // (tests/bench/beside.cpp).
  static void give_way() { std::this_thread::yield(); }
  // Runs the waiting jobs that are over: their places are free.
  void drop_over();

 private:
  void work(bool lowest);
  void close();

  const std::size_t max_jobs_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Job> waiting_;  // entries move between lists, which needs no memory
  std::size_t running_ = 0;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace gonio::server
