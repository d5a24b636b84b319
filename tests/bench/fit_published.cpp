// Fits against the best that is published for the same materials.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "fit/published.h"
#include "fit_modes.h"

namespace gonio::bench {
namespace {

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

}  // namespace

bool compare_with_published() {
  struct Model {
    const char *name, *fresnel, *table;
  };
  constexpr std::array kPublished{Model{"cook_torrance", "dielectric", "cooktorrance"},
                                  Model{"ashikhmin_shirley", "", "ashikhminshirley"}};
  std::printf("%-20s %-18s", "material", "model");
  for (const fit::Objective objective : kObjectives)
    std::printf("  %10s", std::string(name_of(objective)).c_str());
  std::printf("   (ours / published)\n");
  int cells = 0, better = 0;
  for (const char* material : testing::kFitMaterials) {
    const fit::Data data = load(material);
    for (const Model& model : kPublished) {
      std::printf("%-20s %-18s", material, model.name);
      for (const fit::Objective objective : kObjectives) {
        fit::Options options;
        options.objective = objective;
        options.max_theta = fit::kGrazing;
        const auto form = testing::over_lambertian(model.name, model.fresnel);
        const auto result = fit::fit(data, form, options);
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
  return better == cells;
}

}  // namespace gonio::bench
