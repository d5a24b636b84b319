// Ends of random starts, compared with the best objective that any start of any procedure finds.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "fit_modes.h"

namespace gonio::bench {
namespace {

constexpr double kAgree = 1.01;

// The ends of one start by each procedure.
struct Ends {
  double automatic, staged;
  bool alone;      // auto's own descent from the guess: with the best of its starts?
  double seconds;  // auto's
};

Ends ends_of(const fit::Data& data, const MaterialSpec& form) {
  fit::Options options;
  const auto found = fit::fit(data, form, options);
  options.strategy = fit::Strategy::staged;
  const auto staged = fit::fit(data, form, options);
  const auto& starts = found->certificate.starts;
  const bool alone = std::any_of(starts.begin(), starts.end(),
                                 [](const fit::Start& s) { return s.given && s.agrees; });
  return {found->certificate.stages.back().objective, staged->certificate.stages.back().objective,
          alone, found->certificate.cpu_seconds};
}

struct Counts {
  long automatic = 0, alone = 0, staged = 0, total = 0;
};

void print_row(const char* name, bool noisy, const char* model, const std::vector<Ends>& ends,
               Counts& sums) {
  double best = 1e300, worst = 0, seconds = 0;
  for (const Ends& e : ends) best = std::min({best, e.automatic, e.staged});
  Counts row;
  for (const Ends& e : ends) {
    worst = std::max(worst, e.automatic);
    seconds += e.seconds;
    row.automatic += e.automatic <= kAgree * best ? 1 : 0;
    row.staged += e.staged <= kAgree * best ? 1 : 0;
    row.alone += e.alone ? 1 : 0;
  }
  row.total = static_cast<long>(ends.size());
  std::printf("%-20s%s %-14s %.5f  %.3f %%  %4ld %6ld %6ld  of %ld  %.2f s\n", name,
              noisy ? "*" : " ", model, best, 100 * (worst / best - 1), row.automatic, row.alone,
              row.staged, row.total, seconds / static_cast<double>(ends.size()));
  std::fflush(stdout);
  sums.automatic += row.automatic;
  sums.alone += row.alone;
  sums.staged += row.staged;
  sums.total += row.total;
}

}  // namespace

bool print_independence(int starts) {
  std::printf("L1 on 20,000 pairs below 80 degrees. Ends within 1 %% of the best: auto with the\n");
  std::printf("random start as its guess; that guess's descent alone; the three stages as\n");
  std::printf("printed. *: noise of 10 %%, 2 %% invalid. worst: of auto, above the best\n");
  std::printf("%-21s %-14s best     worst    auto  alone staged         CPU\n", "material",
              "model");
  Counts sums;
  for (std::size_t set = 0; set < testing::kFitMaterials.size() + kNoisySets; ++set) {
    const bool noisy = set >= testing::kFitMaterials.size();
    const char* name = testing::kFitMaterials[set % testing::kFitMaterials.size()];
    const fit::Data all = load(name, noisy ? 0.1 : 0, noisy ? 0.02 : 0);
    const fit::Data data = fit::subset(fit::within(all, 0, fit::kGrazing), 20'000, 1);
    for (const char* model : kModels) {
      std::mt19937_64 random(1);
      std::vector<Ends> ends;
      for (int start = 0; start < starts; ++start) {
        MaterialSpec form = testing::over_lambertian(model, "dielectric");
        testing::draw_start(random, form.specular[0]);
        ends.push_back(ends_of(data, form));
      }
      print_row(name, noisy, model, ends, sums);
    }
  }
  std::printf("auto %ld, the guess alone %ld, staged %ld of %ld\n", sums.automatic, sums.alone,
              sums.staged, sums.total);
  return sums.automatic == sums.total;
}

}  // namespace gonio::bench
