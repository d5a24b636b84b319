// Selections on references whose model is known, and on measured materials.
//
//   select_bench trials [N]      N (100) trials over all truths, 2 % noise: is the generating model
//                                chosen, one with no more numbers, a larger one, or nothing?
//   select_bench confidence [N]  N (400) choices at tolerances next to what they err by: how many
//                                miss it on fresh directions, at 95 % confidence
//   select_bench coverage [N]    N (400) bounds for each truth: how many are too low
//   select_bench materials [X]   choices on measured materials at three tolerances, as Markdown;
//   only
//                                those with X in their names
//   select_bench views           choices for views near the normal and grazing ones, and why
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string_view>

#include "select/trials.h"
#include "select_materials.h"

namespace gonio::bench {
namespace {

using testing::truths;

struct Tally {
  int trials = 0, generating = 0, other = 0, larger = 0, nothing = 0;
};

void print(const char* name, const Tally& t) {
  std::printf("%-46s %6d %10d %8d %7d %8d\n", name, t.trials, t.generating, t.other, t.larger,
              t.nothing);
}

bool trials(std::size_t count) {
  std::map<std::string, Tally> by_truth;
  Tally all;
  for (std::size_t i = 0; i < count; ++i) {
    const testing::Truth& truth = truths()[i % truths().size()];
    const testing::Trial trial = run_trial(truth, i + 1);
    for (Tally* tally : {&by_truth[truth.name], &all}) {
      const bool same = trial.chosen == truth.name, nothing = trial.chosen == "nothing";
      ++tally->trials;
      tally->generating += same ? 1 : 0;
      tally->nothing += nothing ? 1 : 0;
      tally->larger += trial.larger ? 1 : 0;
      tally->other += !same && !nothing && !trial.larger ? 1 : 0;
    }
    if (trial.chosen != truth.name)
      std::printf("  seed %zu: %s came back as %s\n", i + 1, truth.name.c_str(),
                  trial.chosen.c_str());
  }
  std::printf("\n%-46s %6s %10s %8s %7s %8s\n", "generating model", "trials", "recovered",
              "no larger", "larger", "nothing");
  for (const auto& [name, tally] : by_truth) print(name.c_str(), tally);
  print("all", all);
  const bool met = 100 * all.generating >= 95 * all.trials;
  std::printf("%s: at least 95 %% recovered\n", met ? "met" : "NOT MET");
  return met;
}

// How many misses as many trials as `count` may have, each with a probability of .05, without it
// being strange: the mean and two standard deviations.
double most_misses(int count) { return 0.05 * count + 2 * std::sqrt(0.05 * 0.95 * count); }

bool confidence(std::size_t count) {
  int chosen = 0, misses = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const testing::Check check = run_check(truths()[i % truths().size()], 100'000 + 10 * i);
    chosen += check.chosen ? 1 : 0;
    misses += check.misses ? 1 : 0;
  }
  std::printf("%zu selections, %d choices, %d miss the tolerance on fresh directions: %.1f %%\n",
              count, chosen, misses, 100.0 * misses / std::max(chosen, 1));
  const bool met = misses <= most_misses(chosen);
  std::printf("%s: at most %.0f, for a confidence of 95 %%\n", met ? "met" : "NOT MET",
              most_misses(chosen));
  return met;
}

// The bounds by themselves, where each miss counts: no choosing between.
bool coverage(std::size_t draws) {
  testing::Coverage all;
  for (const testing::Truth& truth : truths()) {
    const auto one = run_coverage(truth, 4321, draws, 2000);
    std::printf("%-46s %5.1f %% of %zu bounds are too low\n", truth.name.c_str(),
                100.0 * static_cast<double>(one.misses) / static_cast<double>(one.draws),
                one.draws);
    all.draws += one.draws, all.misses += one.misses;
  }
  const bool met = static_cast<double>(all.misses) <= most_misses(static_cast<int>(all.draws));
  std::printf("%s: %.2f %% in all, for a confidence of 95 %%\n", met ? "met" : "NOT MET",
              100.0 * static_cast<double>(all.misses) / static_cast<double>(all.draws));
  return met;
}

int run(int argc, char** argv) {
  const std::string_view mode = argc > 1 ? argv[1] : "";
  const int count = argc > 2 ? std::atoi(argv[2]) : 0;
  const auto or_else = [&](std::size_t n) {
    return count > 0 ? static_cast<std::size_t>(count) : n;
  };
  if (mode == "trials") return trials(or_else(100)) ? 0 : 1;
  if (mode == "confidence") return confidence(or_else(400)) ? 0 : 1;
  if (mode == "coverage") return coverage(or_else(400)) ? 0 : 1;
  if (mode == "materials") return print_choices(argc > 2 ? argv[2] : "") ? 0 : 1;
  if (mode == "views") return print_by_view() ? 0 : 1;
  std::fprintf(stderr, "usage: select_bench trials|confidence|coverage|materials|views [N]\n");
  return 2;
}

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) { return gonio::bench::run(argc, argv); }
