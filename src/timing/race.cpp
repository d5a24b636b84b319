#include "timing/race.h"

#include <algorithm>
#include <ctime>
#include <numeric>
#include <random>

namespace gonio::timing {
namespace {

double seconds_of(const Runner& runner, std::uint64_t runs, Clock clock) {
  const double start = now(clock);
  for (std::uint64_t i = 0; i < runs; ++i) runner.run();
  return now(clock) - start;
}

// The number of runs that together take the time of a repetition. Measuring it warms the runner up.
std::uint64_t runs_of(const Runner& runner, const Effort& effort) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 32U;
  runner.run();
  for (std::uint64_t runs = 1;;) {
    const double seconds = seconds_of(runner, runs, effort.clock);
    if (seconds >= effort.seconds || runs >= kMost) return runs;
    // A little more than the estimate; ten times as many where the time was too short to estimate
    // from.
    const double wanted = seconds > 0 ? 1.2 * effort.seconds / seconds : 10;
    runs =
        static_cast<std::uint64_t>(static_cast<double>(runs) * std::clamp(wanted, 1.1, 10.0)) + 1;
  }
}

}  // namespace

double now(Clock clock) {
  timespec time{};
  clock_gettime(clock == Clock::thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::vector<Spread> race(std::span<const Runner> runners, const Effort& effort,
                         const std::function<bool()>& stop) {
  const auto is_over = [&stop] { return stop && stop(); };
  std::vector<std::uint64_t> runs(runners.size());
  for (std::size_t i = 0; i < runners.size() && !is_over(); ++i)
    runs[i] = runs_of(runners[i], effort);
  std::vector<std::vector<double>> times(runners.size());
  std::vector<std::size_t> order(runners.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(1);
  for (int round = 0; round < effort.repetitions && !is_over(); ++round) {
    std::ranges::shuffle(order, random);
    for (const std::size_t i : order) {
      if (is_over()) break;
      times[i].push_back(seconds_of(runners[i], runs[i], effort.clock) /
                         (static_cast<double>(runs[i]) * runners[i].items));
    }
  }
  std::vector<Spread> spreads;
  spreads.reserve(times.size());
  for (const auto& all : times) spreads.push_back(spread_of(all));
  return spreads;
}

}  // namespace gonio::timing
