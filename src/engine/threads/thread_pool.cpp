#include "gonio/engine/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "engine/threads/shared_run.h"
#include "engine/threads/stay_alert.h"

namespace gonio {
namespace {

struct Active {
  ThreadPool::Job job;
  bool awaited = false;                  // a caller waits for it now, and may soon have the next
  std::size_t next = 0;                  // guarded by the pool's mutex
  std::size_t running = 0;               // tiles begun and not ended; guarded
  bool stopped = false;                  // guarded
  std::exception_ptr failure = nullptr;  // the first of the job's; guarded until its end
};

using ActivePtr = std::shared_ptr<Active>;

// Whether the job's other tiles are to be abandoned, and what was thrown.
struct TileOutcome {
  bool stop = false;
  std::exception_ptr failure = nullptr;
};

TileOutcome run_tile(const ThreadPool::Job& job, std::size_t tile) {
  try {
    if (job.stop && job.stop()) return {true};
    job.run(tile);
    return {};
  } catch (...) {
    return {true, std::current_exception()};
  }
}

void end_job(const Active& active) {
  if (active.failure && active.job.failed) {
    active.job.failed(active.failure);
  } else if (active.job.done) {
    active.job.done(!active.stopped);
  }
}

}  // namespace

struct ThreadPool::State {
  std::mutex mutex;
  std::condition_variable work;
  // Jobs with tiles left to begin; turned round after each tile. Turning allocates nothing, so that
  // no thread of the pool can run out of memory between two tiles.
  std::list<ActivePtr> ready;
  std::size_t max_jobs = 0;
  std::size_t jobs = 0;
  std::size_t asleep = 0;                 // threads; guarded
  std::atomic<std::size_t> waiting{0};    // the size of `ready`, to be looked at without the mutex
  std::atomic<Clock::rep> last_brief{0};  // when a brief run last ended
  bool closing = false;
  std::vector<std::thread> threads;

  // `entry` holds one job. The caller holds the mutex.
  void put(std::list<ActivePtr>& entry) {
    ready.splice(ready.end(), entry);
    waiting.store(ready.size());
  }
  void remove(const ActivePtr& active) {
    ready.remove(active);
    waiting.store(ready.size());
  }

  // Takes the next tile of the job at the front. The caller holds the mutex.
  ActivePtr take(std::size_t& tile) {
    ActivePtr active = ready.front();
    tile = active->next++;
    ++active->running;
    if (active->next < active->job.tiles) {
      ready.splice(ready.end(), ready, ready.begin());
    } else {
      ready.pop_front();
    }
    waiting.store(ready.size());
    return active;
  }

  // Runs a taken tile; ends the job with its last one.
  void run(const ActivePtr& active, std::size_t tile) {
    TileOutcome outcome = run_tile(active->job, tile);
    bool last = false;
    {
      const auto lock = lock_soon(mutex);
      if (outcome.stop && !active->stopped) {
        active->stopped = true;
        active->next = active->job.tiles;
        remove(active);
      }
      if (!active->failure) active->failure = std::move(outcome.failure);
      last = --active->running == 0 && active->next >= active->job.tiles;
      // Its place is free before its end is told, which may submit the next job.
      if (last) --jobs;
      if (last && closing) work.notify_all();
    }
    if (last) end_job(*active);
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

  // Wakes as many threads as there are tiles for.
  void wake(std::size_t tiles, std::size_t sleepers) {
    for (std::size_t i = 0; i < std::min(tiles, sleepers); ++i) work.notify_one();
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
  // All that needs memory comes before a place is taken.
  std::list<ActivePtr> entry{std::make_shared<Active>()};
  const ActivePtr active = entry.front();
  const std::size_t tiles = job.tiles;
  std::size_t asleep = 0;
  {
    const auto lock = lock_soon(state_->mutex);
    if (state_->jobs >= state_->max_jobs) return false;
    active->job = std::move(job);
    if (tiles > 0) {
      ++state_->jobs;
      state_->put(entry);
      asleep = state_->asleep;
    }
  }
  if (tiles == 0) return end_job(*active), true;
  state_->wake(tiles, asleep);
  return true;
}

void ThreadPool::run(std::size_t tiles, const std::function<void(std::size_t)>& body, bool brief) {
  SharedRun shared(body, tiles);
  // One tile of the job for each helper: a helper that comes late finds nothing left to do.
  const std::size_t helpers = std::min(tiles - 1, state_->threads.size());
  if (tiles <= 1 || (brief && !state_->shares_brief())) {
    shared.drain();
    if (tiles > 1) state_->end_brief();
    return shared.rethrow();
  }
  Job job{helpers, [&](std::size_t) { shared.drain(); }, {}, [&](bool) { shared.end(); }};
  std::list<ActivePtr> entry{std::make_shared<Active>(Active{std::move(job), true})};
  const ActivePtr active = entry.front();
  std::size_t asleep = 0;
  {
    const auto lock = lock_soon(state_->mutex);
    ++state_->jobs;
    state_->put(entry);
    asleep = state_->asleep;
  }
  state_->wake(helpers, asleep);
  shared.drain();
  if (!state_->withdraw(active)) shared.wait();
  if (brief) state_->end_brief();
  shared.rethrow();
}

int ThreadPool::threads() const { return static_cast<int>(state_->threads.size()); }

std::size_t ThreadPool::jobs() const {
  const auto lock = lock_soon(state_->mutex);
  return state_->jobs;
}

}  // namespace gonio
