#include "server/work/background_queue.h"

#include <sys/resource.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace gonio::server {
namespace {

constexpr int kLowestPriority = 19;  // the nice value

}  // namespace

BackgroundQueue::BackgroundQueue(int threads, std::size_t max_jobs, bool lowest)
    : max_jobs_(max_jobs) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this, lowest] { work(lowest); });
}

BackgroundQueue::~BackgroundQueue() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

bool BackgroundQueue::submit(Job job) {
  {
    const std::lock_guard lock(mutex_);
    if (running_ + waiting_.size() >= max_jobs_) return false;
    waiting_.push_back(std::move(job));
  }
  changed_.notify_one();
  return true;
}

void BackgroundQueue::drop_over() {
  std::deque<Job> over;
  {
    const std::lock_guard lock(mutex_);
    const auto first = std::stable_partition(waiting_.begin(), waiting_.end(),
                                             [](const Job& job) { return !job.is_over(); });
    std::move(first, waiting_.end(), std::back_inserter(over));
    waiting_.erase(first, waiting_.end());
  }
  for (const Job& job : over) job.run();
}

void BackgroundQueue::work(bool lowest) {
  // Of this thread alone, as Linux has it. Where it is refused, fits only share more.
  if (lowest) setpriority(PRIO_PROCESS, 0, kLowestPriority);
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    {
      const Job job = std::move(waiting_.front());
      waiting_.pop_front();
      ++running_;
      lock.unlock();
      job.run();
    }
    lock.lock();
    --running_;
  }
}

}  // namespace gonio::server
