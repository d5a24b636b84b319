// Fits against the best that is published for eight materials, and what they cost.
//
//   fit_bench published    64 cells: two models x eight materials x four metrics, at theta <= 80 deg
//   fit_bench time         CPU seconds of each model and objective on 20,000 pairs, and polished
#include <algorithm>
#include <cstdio>
#include <cstring>

#include "fit/fit.h"
#include "fit/published.h"
#include "measured/npf_material.h"
#include "measured/table.h"

namespace gonio::bench {
namespace {

constexpr std::array kMaterials{"nickel", "two-layer-silver",    "violet-rubber", "red-fabric2",
                                "chrome", "gold-metallic-paint", "blue-acrylic",  "white-diffuse-bball"};
constexpr std::array kObjectives{fit::Objective::l1, fit::Objective::l2, fit::Objective::log,
                                 fit::Objective::cbrt};

fit::Data load(const char* name) {
  const auto material = testing::NpfMaterial::load(name);
  if (!material) {
    std::fprintf(stderr, "fit_bench: no material '%s' in %s\n", name,
                 testing::data_folder().c_str());
    std::exit(1);
  }
  return fit::from_table(**MeasuredTable::from_values(testing::tabulate(*material)));
}

double metric(const fit::Errors& errors, fit::Objective objective) {
  switch (objective) {
    case fit::Objective::l2: return errors.rmse;
    case fit::Objective::log: return errors.log;
    case fit::Objective::cbrt: return errors.cbrt;
    default: return errors.l1;
  }
}

MaterialSpec form_of(const std::string& model, const std::string& fresnel) {
  MaterialSpec form;
  form.diffuse = LobeSpec{"lambertian", {}};
  form.specular = {LobeSpec{model, {}}};
  if (!fresnel.empty()) form.specular[0].parameters["fresnel"] = fresnel;
  return form;
}

// The least error that a paper's parameters have.
double best_published(const std::string& model, const std::string& material, const fit::Data& data,
                      fit::Objective objective) {
  double best = 1e300;
  for (const char* table : {"low_%s_E1", "low_%s_E2", "ngan_%s"}) {
    char name[64];
    std::snprintf(name, sizeof name, table, model.c_str());
    const auto spec = testing::published(name, material);
    if (!spec) continue;
    const auto made = Material::create(*spec);
    if (!made) std::printf("%s\n", made.error().message.c_str()), std::exit(1);
    best = std::min(best, metric(fit::compare(*made, data, 0).errors.below_80, objective));
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
  for (const char* material : kMaterials) {
    const fit::Data data = load(material);
    for (const Model& model : kModels) {
      std::printf("%-20s %-18s", material, model.name);
      for (const fit::Objective objective : kObjectives) {
        fit::Options options;
        options.objective = objective;
        options.max_theta = fit::kGrazing;
        const auto result = fit::fit(data, form_of(model.name, model.fresnel), options);
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
  for (const char* material : kMaterials) {
    const fit::Data all = load(material);
    const fit::Data data = fit::subset(fit::within(all, 0, fit::kGrazing), 20'000, 1);
    for (const char* model : {"cook_torrance", "phong", "blinn_phong", "phong_mix"}) {
      std::printf("%-20s %-18s", material, model);
      for (const fit::Objective objective : kObjectives) {
        fit::Options options;
        options.objective = objective;
        const auto result = fit::fit(data, form_of(model, "dielectric"), options);
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

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) {
  const std::string what = argc == 2 ? argv[1] : "";
  if (what == "published") return gonio::bench::compare_with_published();
  if (what == "time") return gonio::bench::print_times(), 0;
  std::fputs("usage: fit_bench published|time\n", stderr);
  return 2;
}
