#include "server/work/calls_under_way.h"

#include <algorithm>

namespace gonio::server {
namespace {

constexpr std::chrono::milliseconds kMoment{100}, kStep{5};

}  // namespace

void CallsUnderWay::wait_for_none(Clock::time_point deadline) {
  std::uint64_t begun = begun_;
  auto quiet_from = Clock::now();
  std::unique_lock lock(mutex_);
  for (auto now = quiet_from; !hurry_ && now < deadline; now = Clock::now()) {
    if (under_way_ > 0 || begun_ != begun) quiet_from = now;
    if (now - quiet_from >= kMoment) return;
    begun = begun_;
    hurried_.wait_for(lock, kStep);
  }
}

void CallsUnderWay::wait_until(Clock::time_point time) {
  std::unique_lock lock(mutex_);
  hurried_.wait_until(lock, time, [this] { return hurry_; });
}

void CallsUnderWay::hurry() {
  const std::lock_guard lock(mutex_);
  hurry_ = true;
  hurried_.notify_all();
}

}  // namespace gonio::server
