#include "gonio/engine/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/threads/stay_alert.h"

namespace gonio {
namespace {

struct Active {
  ThreadPool::Job job;
  bool awaited = false;     // a caller waits for it now, and may soon have the next
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
  std::size_t asleep = 0;                 // threads; guarded
  std::atomic<std::size_t> waiting{0};    // the size of `ready`, to be looked at without the mutex
  std::atomic<Clock::rep> last_brief{0};  // when a brief run last ended
  bool closing = false;
  std::vector<std::thread> threads;

  void put(const ActivePtr& active) {
    ready.push_back(active);
    waiting.store(ready.size());
  }
  void remove(const ActivePtr& active) {
    std::erase(ready, active);
    waiting.store(ready.size());
  }

  // Takes the next tile of the job at the front. The caller holds the mutex.
  ActivePtr take(std::size_t& tile) {
    ActivePtr active = ready.front();
    ready.pop_front();
    tile = active->next++;
    ++active->running;
    if (active->next < active->job.tiles) ready.push_back(active);
    waiting.store(ready.size());
    return active;
  }

  // Runs a taken tile; ends the job with its last one.
  void run(const ActivePtr& active, std::size_t tile) {
    const bool stop = active->job.stop && active->job.stop();
    if (!stop) active->job.run(tile);
    bool last = false;
    {
      const auto lock = lock_soon(mutex);
      if (stop && !active->stopped) {
        active->stopped = true;
        active->next = active->job.tiles;
        remove(active);
      }
      last = --active->running == 0 && active->next >= active->job.tiles;
      // Its place is free before `done` is told, which may submit the next job.
      if (last) --jobs;
      if (last && closing) work.notify_all();
    }
    if (last && active->job.done) active->job.done(!active->stopped);
  }

  void work_on() {
    std::unique_lock lock = lock_soon(mutex);
    for (;;) {
      ++asleep;
      work.wait(lock, [this] { return !ready.empty() || (closing && jobs == 0); });
      --asleep;
      if (ready.empty()) return;
      std::size_t tile = 0;
      ActivePtr active = take(tile);
      lock.unlock();
      run(active, tile);
      if (active->awaited) stay_alert([this] { return waiting.load() != 0; });
      active.reset();
      lock = lock_soon(mutex);
    }
  }

  void add(const ActivePtr& active) {
    std::size_t wanted = 0;
    {
      const auto lock = lock_soon(mutex);
      put(active);
      wanted = std::min(active->job.tiles, asleep);
    }
    for (std::size_t i = 0; i < wanted; ++i) work.notify_one();
  }

  // Takes back the tiles of an awaited job that no thread has begun: the work is done. True if
  // nothing remains to wait for.
  bool withdraw(const ActivePtr& active) {
    const auto lock = lock_soon(mutex);
    if (active->next == active->job.tiles) return false;
    active->next = active->job.tiles;
    remove(active);
    if (active->running != 0) return false;
    --jobs;
    if (closing) work.notify_all();
    return true;
  }

  void close() {
    {
      const auto lock = lock_soon(mutex);
      closing = true;
    }
    work.notify_all();
    for (std::thread& thread : threads) thread.join();
  }

  // Whether brief work should be shared: a thread is awake, or such work comes so often that waking
  // one pays with the next.
  bool shares_brief() {
    const Clock::rep now = Clock::now().time_since_epoch().count();
    if (Clock::duration(now - last_brief.load()) < kAlert) return true;
    const auto lock = lock_soon(mutex);
    return asleep < threads.size();
  }
  // The end counts, and not the beginning: what comes between two runs is then the caller's own
  // time, however long the runs themselves take.
  void end_brief() { last_brief.store(Clock::now().time_since_epoch().count()); }
};

ThreadPool::ThreadPool(int threads, std::size_t max_jobs) : state_(std::make_unique<State>()) {
  state_->max_jobs = max_jobs;
  try {
    for (int i = 0; i < threads; ++i)
      state_->threads.emplace_back([state = state_.get()] { state->work_on(); });
  } catch (...) {  // no more threads or memory: those that run must not outlive what they wait for
    state_->close();
    throw;
  }
}

ThreadPool::~ThreadPool() { state_->close(); }

bool ThreadPool::submit(Job&& job) {
  {
    const auto lock = lock_soon(state_->mutex);
    if (state_->jobs >= state_->max_jobs) return false;
    if (job.tiles > 0) ++state_->jobs;
  }
  const auto active = std::make_shared<Active>(Active{std::move(job)});
  if (active->job.tiles > 0) return state_->add(active), true;
  if (active->job.done) active->job.done(true);
  return true;
}

void ThreadPool::run(std::size_t tiles, const std::function<void(std::size_t)>& body, bool brief) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::condition_variable finished;
  std::atomic<bool> done = false;  // set under the mutex
  const auto drain = [&](std::size_t) {
    for (std::size_t i = next.fetch_add(1); i < tiles; i = next.fetch_add(1)) body(i);
  };
  // One tile of the job for each helper: a helper that comes late finds nothing left to do.
  const std::size_t helpers = std::min(tiles - 1, state_->threads.size());
  if (tiles <= 1) return drain(0);
  if (brief && !state_->shares_brief()) return drain(0), state_->end_brief();
  const auto end = [&](bool) {
    const auto lock = lock_soon(mutex);
    done = true;
    finished.notify_one();
  };
  const auto active = std::make_shared<Active>(Active{{helpers, drain, {}, end}, true});
  {
    const auto lock = lock_soon(state_->mutex);
    ++state_->jobs;
  }
  state_->add(active);
  drain(0);
  if (!state_->withdraw(active)) {
    stay_alert([&] { return done.load(); });
    std::unique_lock lock = lock_soon(mutex);
    finished.wait(lock, [&] { return done.load(); });
  }
  if (brief) state_->end_brief();
}

int ThreadPool::threads() const { return static_cast<int>(state_->threads.size()); }

std::size_t ThreadPool::jobs() const {
  const auto lock = lock_soon(state_->mutex);
  return state_->jobs;
}

}  // namespace gonio
