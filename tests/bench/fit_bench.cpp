// Fits against the best that is published for eight materials, and what they cost.
//
//   fit_bench published    64 cells: two models x eight materials x four metrics, at theta <= 80
//   deg fit_bench time         CPU seconds of each model and objective on 20,000 pairs, and
//   polished
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "fit/fit.h"
#include "fit/published.h"
#include "fit/real_data.h"

namespace gonio::bench {
namespace {

using testing::draw_start;
using testing::kFitMaterials;
using testing::load_measured;
using testing::over_lambertian;

constexpr std::array kObjectives{fit::Objective::l1, fit::Objective::l2, fit::Objective::log,
                                 fit::Objective::cbrt};

fit::Data load(const char* name, double noise = 0, double invalid = 0) {
  auto data = load_measured(name, noise, invalid);
  if (!data) {
    std::fprintf(stderr, "fit_bench: no material '%s' in %s\n", name,
                 testing::data_folder().c_str());
    std::exit(1);
  }
  return *std::move(data);
}

double metric(const fit::Errors& errors, fit::Objective objective) {
  switch (objective) {
    case fit::Objective::l2:
      return errors.rmse;
    case fit::Objective::log:
      return errors.log;
    case fit::Objective::cbrt:
      return errors.cbrt;
    default:
      return errors.l1;
  }
}

// The least error that a paper's parameters have.
double best_published(const std::string& model, const std::string& material, const fit::Data& data,
                      fit::Objective objective) {
  double best = 1e300;
  for (const char* table : {"low_%s_E1", "low_%s_E2", "ngan_%s"}) {
    char name[64];
    std::snprintf(name, sizeof name, table, model.c_str());
    for (const MaterialSpec& spec : testing::published(name, material)) {
      const auto made = Material::create(spec);
      if (!made) std::printf("%s\n", made.error().message.c_str()), std::exit(1);
      best = std::min(best, metric(fit::compare(*made, data, 0).errors.below_80, objective));
    }
  }
  return best;
}

int compare_with_published() {
  struct Model {
    const char *name, *fresnel, *table;
  };
  constexpr std::array kModels{Model{"cook_torrance", "dielectric", "cooktorrance"},
                               Model{"ashikhmin_shirley", "", "ashikhminshirley"}};
  int cells = 0, better = 0;
  for (const char* material : kFitMaterials) {
    const fit::Data data = load(material);
    for (const Model& model : kModels) {
      std::printf("%-20s %-18s", material, model.name);
      for (const fit::Objective objective : kObjectives) {
        fit::Options options;
        options.objective = objective;
        options.max_theta = fit::kGrazing;
        const auto result = fit::fit(data, over_lambertian(model.name, model.fresnel), options);
        const double ours = metric(result->certificate.errors.below_80, objective);
        const double theirs = best_published(model.table, material, data, objective);
        ++cells;
        better += ours <= theirs ? 1 : 0;
        std::printf("  %.4g / %.4g%s", ours, theirs, ours <= theirs ? "" : " WORSE");
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  std::printf("%d of %d cells not worse than published\n", better, cells);
  return better == cells ? 0 : 1;
}

void print_times() {
  for (const char* material : kFitMaterials) {
    const fit::Data all = load(material);
    const fit::Data data = fit::subset(fit::within(all, 0, fit::kGrazing), 20'000, 1);
    for (const char* model : {"cook_torrance", "phong", "blinn_phong", "phong_mix"}) {
      std::printf("%-20s %-18s", material, model);
      for (const fit::Objective objective : kObjectives) {
        fit::Options options;
        options.objective = objective;
        const auto result = fit::fit(data, over_lambertian(model, "dielectric"), options);
        std::printf("  %.4g in %.3f s", metric(result->certificate.errors.below_80, objective),
                    result->certificate.cpu_seconds);
        for (const auto& s : result->certificate.stages)
          std::printf(" %s %d %.3f", s.name.c_str(), s.iterations, s.cpu_seconds);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
}

// Ends of random starts, compared with the best objective that any start of either strategy finds.
void print_independence(int starts) {
  constexpr std::array kModels{"phong", "blinn_phong", "phong_mix", "cook_torrance"};
  std::array<int, 2> good{};
  int total = 0;
  for (std::size_t set = 0; set < kFitMaterials.size() + 4; ++set) {
    const bool noisy = set >= kFitMaterials.size();
    const char* name = kFitMaterials[set % kFitMaterials.size()];
    const fit::Data data =
        fit::within(load(name, noisy ? 0.1 : 0, noisy ? 0.02 : 0), 0, fit::kGrazing);
    for (const char* model : kModels) {
      std::array<std::vector<double>, 2> ends;
      std::mt19937_64 random(1);
      double seconds = 0;
      for (int start = 0; start < starts; ++start) {
        MaterialSpec form = over_lambertian(model, "dielectric");
        draw_start(random, form.specular[0]);
        for (std::size_t strategy = 0; strategy < 2; ++strategy) {
          fit::Options options;
          options.strategy = strategy == 0 ? fit::Strategy::automatic : fit::Strategy::staged;
          const auto result = fit::fit(data, form, options);
          ends[strategy].push_back(result->certificate.stages.back().objective);
          if (strategy == 0) seconds += result->certificate.cpu_seconds;
        }
      }
      double best = 1e300;
      for (const auto& all : ends) best = std::min(best, *std::min_element(all.begin(), all.end()));
      std::printf("%-20s%s %-14s best %.4f", name, noisy ? "*" : " ", model, best);
      for (std::size_t strategy = 0; strategy < 2; ++strategy) {
        const auto count = std::count_if(ends[strategy].begin(), ends[strategy].end(),
                                         [&](double end) { return end <= 1.01 * best; });
        good[strategy] += static_cast<int>(count);
        std::printf("  %s %ld", strategy == 0 ? "auto" : "staged", count);
      }
      std::printf(" of %d  (auto %.2f s)\n", starts, seconds / starts);
      std::fflush(stdout);
      total += starts;
    }
  }
  std::printf("auto %d, staged %d of %d\n", good[0], good[1], total);
}

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "published") return gonio::bench::compare_with_published();
  if (what == "time") return gonio::bench::print_times(), 0;
  if (what == "starts")
    return gonio::bench::print_independence(argc > 2 ? std::atoi(argv[2]) : 50), 0;
  std::fputs("usage: fit_bench published|starts [N]|time\n", stderr);
  return 2;
}
