// Times several kinds of work against one another in one run.
//
// Every runner is warmed up, and told how often it has to run for a repetition to be long enough.
// Then come rounds: in each of them every runner has one repetition, in an order that changes, so
// that whatever else the machine does hits all of them alike.
//
//   std::vector<timing::Runner> runners{timing::evaluation(pairs, gold, Precision::fast, isa),
//   ...}; const auto seconds = timing::race(runners, {});  // seconds[i].best: of one pair
//
// Thread safety: functions without state; the runners run on the calling thread.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "timing/spread.h"

namespace gonio::timing {

// Something to be timed; one run does `items` of what is counted: pairs, samples, calls.
struct Runner {
  std::function<void()> run;
  double items = 1;
};

enum class Clock : std::uint8_t {
  thread,  // this thread's processor time: what other processes take does not count
  wall,    // for work that waits for other threads
};

// By default what tests/bench spends.
struct Effort {
  int repetitions = 25;
  double seconds = 0.004;  // that a repetition takes at least
  Clock clock = Clock::thread;
};

// Seconds an item of each runner, in their order. `stop` is asked before every repetition; once it
// says so, the spreads are those of what was done until then.
std::vector<Spread> race(std::span<const Runner> runners, const Effort& effort,
                         const std::function<bool()>& stop = {});

// Seconds on a clock, from a beginning of its own.
double now(Clock clock);

}  // namespace gonio::timing
