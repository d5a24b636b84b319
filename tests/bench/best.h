// The best speed of every benchmark: the machine may be busy, but it is seldom busy throughout.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <string>

namespace gonio::bench {

class Best : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const auto rate = run.counters.find("items_per_second");
      if (run.run_type != Run::RT_Iteration || rate == run.counters.end()) continue;
      double& best = rate_[run.run_name.function_name];
      best = std::max(best, rate->second.value);
    }
    ConsoleReporter::ReportRuns(runs);
  }
  // Items a second; 0 for what was not run.
  [[nodiscard]] double rate(const std::string& name) const {
    const auto found = rate_.find(name);
    return found == rate_.end() ? 0 : found->second;
  }

 private:
  std::map<std::string, double> rate_;
};

// Runs all registered benchmarks, their repetitions interleaved at random.
inline void run_all(int argc, char** argv, Best& best) {
  std::vector<char*> arguments(argv, argv + argc);
  char interleave[] = "--benchmark_enable_random_interleaving=true",
       repetitions[] = "--benchmark_repetitions=25", quick[] = "--benchmark_min_time=0.004";
  arguments.insert(arguments.begin() + 1,
                   {interleave, repetitions, quick});  // the caller's own come later and win
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  benchmark::RunSpecifiedBenchmarks(&best);
}

}  // namespace gonio::bench
