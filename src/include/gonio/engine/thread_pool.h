// One fixed set of compute threads with a bounded queue.
//
// A job is a number of tiles. Workers take tiles of the submitted jobs in turn, so that a short job
// is not held up by a long one; a worker that helps with a run() stays until that is done. What a
// tile throws reaches whoever asked for it, and no thread of the pool ends by it. Thread safety:
// all members may be called from any thread.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>

namespace gonio {

class ThreadPool {
 public:
  // Each job ends once, on the thread that runs its last tile: by `failed` if it is given and a
  // tile or `stop` threw, else by `done`. These two must not throw.
  struct Job {
    std::size_t tiles = 0;
    std::function<void(std::size_t tile)> run;  // called once per tile, from several threads
    // Asked before each tile; true abandons the rest. May be empty.
    std::function<bool()> stop;
    std::function<void(bool completed)> done;  // false: the rest was abandoned
    // The first exception; the rest was abandoned.
    std::function<void(const std::exception_ptr& failure)> failed = {};
  };

  // `threads` >= 1; at most `max_jobs` jobs are queued or running at a time.
  ThreadPool(int threads, std::size_t max_jobs);
  ~ThreadPool();  // finishes the queued jobs first
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  // False (and `job` untouched: it does not end) when the queue is full.
  [[nodiscard]] bool submit(Job&& job);

  // Runs body(0) ... body(tiles - 1) on the pool and the calling thread; returns when all are done.
  // Never refused. If a tile throws, no further one is begun, and its exception is thrown here once
  // those under way have ended. `brief` says that all of it takes no longer than waking a thread:
  // it is then shared with threads that are still awake from the work before, if any.
  void run(std::size_t tiles, const std::function<void(std::size_t tile)>& body,
           bool brief = false);

  [[nodiscard]] int threads() const;
  [[nodiscard]] std::size_t jobs() const;  // queued or running

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace gonio
