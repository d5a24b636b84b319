// What tests of waiting and of work go by, on machines that do other things too and under
// sanitizers.
#pragma once

#include <chrono>
#include <ctime>

namespace gonio::testing {

#ifdef GONIO_SANITIZED
inline constexpr int kSlower = 20;  // than an optimised build, about
#else
inline constexpr int kSlower = 1;
#endif

// The time that this process's threads have worked, together: what one more job of its own costs
// shows in it, what other processes take does not.
struct WorkClock {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<WorkClock>;
  static constexpr bool is_steady = true;

  static time_point now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return time_point(std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec));
  }
};

}  // namespace gonio::testing
