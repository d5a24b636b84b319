// Waiting awake, for a moment.
#pragma once

#include <emmintrin.h>

#include <chrono>

namespace gonio {

using Clock = std::chrono::steady_clock;

// Sleeping and being woken costs some ten microseconds: who has just worked for a caller that
// waits looks for more this long before sleeping.
constexpr std::chrono::microseconds kAlert{50};

// Returns when `ready` holds or kAlert is over.
void stay_alert(const auto& ready) {
  const Clock::time_point end = Clock::now() + kAlert;
  do {
    for (int i = 0; i < 16; ++i) {
      if (ready()) return;
      _mm_pause();
    }
  } while (Clock::now() < end);
}

}  // namespace gonio
