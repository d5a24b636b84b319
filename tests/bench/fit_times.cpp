// What fits cost: CPU time of the fitting thread, and as a multiple of one evaluation of the pairs,
// which a busy machine slows down as much.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "fit_modes.h"
#include "gonio/engine/evaluate.h"

namespace gonio::bench {
namespace {

constexpr std::size_t kPairs = 20'000;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Of evaluating all pairs once in float64, in three channels; the best of several.
double evaluation_seconds(const MaterialSpec& spec, const fit::Data& data) {
  const auto material = Material::create(spec);
  std::vector<double> values(data.size() * static_cast<std::size_t>(material->channels()));
  const Batch<float, double> batch{data.incident(0), data.outgoing(0), data.size(),
                                   Values<double>::planar(values.data(), data.size()), nullptr};
  double best = 1e300;
  for (int i = 0; i < 20; ++i) {
    const double begin = cpu_seconds();
    evaluate(*material, batch, best_isa());
    best = std::min(best, cpu_seconds() - begin);
  }
  return best;
}

struct Cost {
  double seconds = 1e300, evaluations = 0;
  bool operator<(const Cost& other) const { return seconds < other.seconds; }
};

Cost cost_of(const fit::Data& data, const char* model, const fit::Options& options,
             int repetitions) {
  Cost cost;
  for (int i = 0; i < repetitions; ++i) {
    const auto result = fit::fit(data, testing::over_lambertian(model, "dielectric"), options);
    if (result->certificate.cpu_seconds >= cost.seconds) continue;
    cost.seconds = result->certificate.cpu_seconds;
    cost.evaluations = cost.seconds / evaluation_seconds(result->material, data);
  }
  return cost;
}

// The median and the worst over the materials.
double print_row(std::vector<Cost> costs) {
  std::sort(costs.begin(), costs.end());
  const Cost &median = costs[costs.size() / 2], &most = costs.back();
  std::printf("  %6.3f %6.3f s (%4.0f)", median.seconds, most.seconds, most.evaluations);
  return most.seconds;
}

}  // namespace

bool print_times(int repetitions) {
  std::vector<fit::Data> all;
  for (const char* material : testing::kFitMaterials) all.push_back(load(material));
  std::printf(
      "CPU: median and worst of eight materials; in brackets the worst in evaluations of\n");
  std::printf("the pairs. %zu pairs, best of %d\n%-14s", kPairs, repetitions, "");
  for (const fit::Objective objective : kObjectives)
    std::printf("  %23s", std::string(name_of(objective)).c_str());
  std::printf("  %23s\n", "l1, polished on all");
  bool met = true;
  for (const char* model : kModels) {
    std::printf("%-14s", model);
    for (const fit::Objective objective : kObjectives) {
      const bool slow = objective == fit::Objective::log || objective == fit::Objective::cbrt;
      fit::Options options;
      options.objective = objective;
      std::vector<Cost> costs;
      for (const fit::Data& data : all) {
        const auto pairs = fit::subset(fit::within(data, 0, fit::kGrazing), kPairs, 1);
        costs.push_back(cost_of(pairs, model, options, repetitions));
      }
      met = print_row(std::move(costs)) <= (slow ? 0.6 : 0.3) && met;
      std::fflush(stdout);
    }
    fit::Options options;
    options.polish = true;
    std::vector<Cost> costs;
    for (const fit::Data& data : all) costs.push_back(cost_of(data, model, options, 1));
    met = print_row(std::move(costs)) <= 2 && met;
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("%s: at most .3 s for l1 and l2, .6 s for log and cbrt, 2 s polished\n",
              met ? "met" : "NOT MET");
  return met;
}

}  // namespace gonio::bench
