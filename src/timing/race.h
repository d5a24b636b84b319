// Times several kinds of work against one another in one run.
//
// Every runner is warmed up, and the number of runs is found that makes a repetition long enough.
// Then come rounds. In each round every runner has one repetition, in an order that changes, so
// that other work on the machine affects all of them alike.
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

// Work to be timed. One run processes `items` pairs, samples or calls.
struct Runner {
  std::function<void()> run;
  double items = 1;
};

enum class Clock : std::uint8_t {
  thread,  // CPU time of the calling thread, which other processes do not add to
  wall,    // for work that waits for other threads
};

// The defaults are those of tests/bench.
struct Effort {
  int repetitions = 25;
  double seconds = 0.004;  // the least time of a repetition
  Clock clock = Clock::thread;
};

// Seconds per item of each runner, in their order. `stop` is called before every repetition; after
// it returns true, the spreads are those of the repetitions done so far.
std::vector<Spread> race(std::span<const Runner> runners, const Effort& effort,
                         const std::function<bool()>& stop = {});

// Seconds of a clock, from an arbitrary beginning.
double now(Clock clock);

}  // namespace gonio::timing
