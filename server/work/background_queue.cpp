#include "server/work/background_queue.h"

#include <sys/resource.h>

#include <iterator>
#include <utility>

namespace gonio::server {
namespace {

constexpr int kLowestPriority = 19;  // the nice value

// No job ends the thread that it runs on.
void run_to_its_end(const BackgroundQueue::Job& job) noexcept {
  std::exception_ptr failure;
  try {
    job.run();
  } catch (...) {
    failure = std::current_exception();
  }
  if (failure && job.failed) job.failed(failure);
}

}  // namespace

BackgroundQueue::BackgroundQueue(int threads, std::size_t max_jobs, bool lowest)
    : max_jobs_(max_jobs) {
  try {
    for (int i = 0; i < threads; ++i) threads_.emplace_back([this, lowest] { work(lowest); });
  } catch (...) {  // no more threads or memory: those that run must not outlive the queue
    close();
    throw;
  }
}

BackgroundQueue::~BackgroundQueue() { close(); }

void BackgroundQueue::close() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

bool BackgroundQueue::submit(Job job) {
  std::list<Job> entry;
  entry.push_back(std::move(job));
  {
    const std::lock_guard lock(mutex_);
    if (running_ + waiting_.size() >= max_jobs_) return false;
    waiting_.splice(waiting_.end(), entry);
  }
  changed_.notify_one();
  return true;
}

void BackgroundQueue::drop_over() {
  std::list<Job> over;
  {
    const std::lock_guard lock(mutex_);
    for (auto job = waiting_.begin(); job != waiting_.end();) {
      const auto next = std::next(job);
      if (job->is_over()) over.splice(over.end(), waiting_, job);
      job = next;
    }
  }
  for (const Job& job : over) run_to_its_end(job);
}

void BackgroundQueue::work(bool lowest) {
  // Linux sets the priority of the calling thread alone. Where it is refused, fits only share more.
  if (lowest) setpriority(PRIO_PROCESS, 0, kLowestPriority);
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    {
      std::list<Job> taken;
      taken.splice(taken.end(), waiting_, waiting_.begin());
      ++running_;
      lock.unlock();
      run_to_its_end(taken.front());
    }
    lock.lock();
    --running_;
  }
}

}  // namespace gonio::server
