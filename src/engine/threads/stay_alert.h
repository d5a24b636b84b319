// Waiting awake, for a moment.
#pragma once

#include <chrono>
#include <mutex>

namespace gonio {

using Clock = std::chrono::steady_clock;

// Sleeping and being woken costs some ten microseconds: who has just worked for a caller that
// waits looks for more this long before sleeping.
constexpr std::chrono::microseconds kAlert{50};

// Returns when `ready` holds or kAlert is over.
void stay_alert(const auto& ready) {
  // Reading the clock is pause enough; a pause instruction makes a hypervisor take the processor.
  const Clock::time_point end = Clock::now() + kAlert;
  while (!ready() && Clock::now() < end) {
  }
}

// A lock of a mutex that is only ever held for an instant: sleeping until it is free, and being
// woken, would take a hundred times as long.
inline std::unique_lock<std::mutex> lock_soon(std::mutex& mutex) {
  std::unique_lock lock(mutex, std::try_to_lock);
  for (int i = 0; i < 200 && !lock; ++i) {
    (void)lock.try_lock();
  }
  if (!lock) lock.lock();
  return lock;
}

}  // namespace gonio
