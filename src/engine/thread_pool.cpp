#include "engine/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

namespace gonio {
namespace {

struct Active {
  ThreadPool::Job job;
  std::size_t next = 0;     // guarded by the pool's mutex
  std::size_t running = 0;  // tiles begun and not ended; guarded
  bool stopped = false;     // guarded
};

using ActivePtr = std::shared_ptr<Active>;

}  // namespace

struct ThreadPool::State {
  std::mutex mutex;
  std::condition_variable work;
  std::deque<ActivePtr> ready;  // jobs with tiles left to begin; turned round after each tile
  std::size_t max_jobs = 0;
  std::size_t jobs = 0;
  bool closing = false;
  std::vector<std::thread> threads;

  // Takes the next tile of the job at the front. The caller holds the mutex.
  ActivePtr take(std::size_t& tile) {
    ActivePtr active = ready.front();
    ready.pop_front();
    tile = active->next++;
    ++active->running;
    if (active->next < active->job.tiles) ready.push_back(active);
    return active;
  }

  // Runs a taken tile; ends the job with its last one.
  void run(const ActivePtr& active, std::size_t tile) {
    const bool stop = active->job.stop && active->job.stop();
    if (!stop) active->job.run(tile);
    bool last = false;
    {
      const std::lock_guard lock(mutex);
      if (stop && !active->stopped) {
        active->stopped = true;
        active->next = active->job.tiles;
        std::erase(ready, active);
      }
      last = --active->running == 0 && active->next >= active->job.tiles;
      // Its place is free before `done` is told, which may submit the next job.
      if (last) --jobs;
      if (last && closing) work.notify_all();
    }
    if (last && active->job.done) active->job.done(!active->stopped);
  }

  void work_on() {
    std::unique_lock lock(mutex);
    for (;;) {
      work.wait(lock, [this] { return !ready.empty() || (closing && jobs == 0); });
      if (ready.empty()) return;
      std::size_t tile = 0;
      ActivePtr active = take(tile);
      lock.unlock();
      run(active, tile);
      active.reset();
      lock.lock();
    }
  }

  void add(ActivePtr active) {
    const std::size_t tiles = active->job.tiles;
    {
      const std::lock_guard lock(mutex);
      ready.push_back(std::move(active));
    }
    wake(tiles);
  }

  void wake(std::size_t tiles) {
    for (std::size_t i = 0; i < std::min(tiles, threads.size()); ++i) work.notify_one();
  }
};

ThreadPool::ThreadPool(int threads, std::size_t max_jobs) : state_(std::make_unique<State>()) {
  state_->max_jobs = max_jobs;
  for (int i = 0; i < threads; ++i)
    state_->threads.emplace_back([state = state_.get()] { state->work_on(); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->closing = true;
  }
  state_->work.notify_all();
  for (std::thread& thread : state_->threads) thread.join();
}

bool ThreadPool::submit(Job&& job) {
  {
    const std::lock_guard lock(state_->mutex);
    if (state_->jobs >= state_->max_jobs) return false;
    if (job.tiles > 0) ++state_->jobs;
  }
  auto active = std::make_shared<Active>(Active{std::move(job)});
  if (active->job.tiles > 0) return state_->add(std::move(active)), true;
  if (active->job.done) active->job.done(true);
  return true;
}

void ThreadPool::run(std::size_t tiles, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::condition_variable finished;
  bool done = false;
  const auto drain = [&](std::size_t) {
    for (std::size_t i = next.fetch_add(1); i < tiles; i = next.fetch_add(1)) body(i);
  };
  // One tile of the job for each helper: a helper that comes late finds nothing left to do.
  const std::size_t helpers = std::min(tiles - 1, state_->threads.size());
  auto active = std::make_shared<Active>(Active{{helpers, drain, {}, [&](bool) {
                                                   const std::lock_guard lock(mutex);
                                                   done = true;
                                                   finished.notify_one();
                                                 }}});
  if (tiles > 0 && helpers > 0) {
    {
      const std::lock_guard lock(state_->mutex);
      ++state_->jobs;
    }
    state_->add(active);
    drain(0);
    // Helpers that have not begun are not waited for: the work is done.
    {
      const std::lock_guard lock(state_->mutex);
      if (active->next < active->job.tiles) {
        active->next = active->job.tiles;
        std::erase(state_->ready, active);
        if (active->running == 0) {
          --state_->jobs;
          if (state_->closing) state_->work.notify_all();
          return;
        }
      }
    }
    std::unique_lock lock(mutex);
    finished.wait(lock, [&] { return done; });
    return;
  }
  drain(0);
}

int ThreadPool::threads() const { return static_cast<int>(state_->threads.size()); }

std::size_t ThreadPool::jobs() const {
  const std::lock_guard lock(state_->mutex);
  return state_->jobs;
}

}  // namespace gonio
