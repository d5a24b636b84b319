// The best speed of every benchmark, of repetitions by timing/spread.h.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

#include "timing/race.h"

namespace gonio::bench {

class Best : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const auto rate = run.counters.find("items_per_second");
      if (run.run_type != Run::RT_Iteration || rate == run.counters.end()) continue;
      times_[run.run_name.function_name].push_back(1 / rate->second.value);
    }
    ConsoleReporter::ReportRuns(runs);
  }
  // Items a second; 0 for what was not run.
  [[nodiscard]] double rate(const std::string& name) const {
    const auto found = times_.find(name);
    return found == times_.end() ? 0 : 1 / timing::spread_of(found->second).best;
  }

 private:
  std::map<std::string, std::vector<double>> times_;  // seconds an item
};

// Runs all registered benchmarks, their repetitions interleaved at random.
inline void run_all(int argc, char** argv, Best& best) {
  std::vector<char*> arguments(argv, argv + argc);
  const timing::Effort effort;
  std::string interleave = "--benchmark_enable_random_interleaving=true",
              repetitions = "--benchmark_repetitions=" + std::to_string(effort.repetitions),
              quick = "--benchmark_min_time=" + std::to_string(effort.seconds);
  arguments.insert(arguments.begin() + 1, {interleave.data(), repetitions.data(),
                                           quick.data()});  // the caller's own come later and win
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  benchmark::RunSpecifiedBenchmarks(&best);
}

}  // namespace gonio::bench
