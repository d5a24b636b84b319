// Scratch.
#include <cstdio>
#include <cstring>

#include "engine/isa.h"
#include "fit/fit.h"
#include "fit/search.h"
#include "measured/npf_material.h"
#include "measured/table.h"

using namespace gonio;

int main(int argc, char** argv) {
  const char* model = argc > 1 ? argv[1] : "cook_torrance";
  const char* fresnel = argc > 2 ? argv[2] : "dielectric";
  fit::Options options;
  options.max_theta = fit::kGrazing;
  if (argc > 3) options.objective = static_cast<fit::Objective>(std::atoi(argv[3]));
  if (argc > 4) options.polish = std::atoi(argv[4]);
  for (const char* name : {"nickel", "two-layer-silver", "violet-rubber", "red-fabric2", "chrome",
                           "gold-metallic-paint", "blue-acrylic", "white-diffuse-bball"}) {
    const auto material = testing::NpfMaterial::load(name);
    const auto table = MeasuredTable::from_values(testing::tabulate(*material));
    const double t0 = fit::cpu_seconds();
    const fit::Data data = fit::from_table(**table);
    const double t1 = fit::cpu_seconds();
    MaterialSpec form;
    form.diffuse = LobeSpec{"lambertian", {}};
    form.specular = {LobeSpec{model, {}}};
    if (*fresnel) form.specular[0].parameters["fresnel"] = std::string(fresnel);
    const auto result = fit::fit(data, form, options);
    if (!result) {
      std::printf("%s\n", result.error().message.c_str());
      return 1;
    }
    const auto& c = result->certificate;
    const auto& e = c.errors.below_80;
    std::printf("%-20s data %.2fs l1 %.4f rmse %.4g log %.4g cbrt %.4g  cpu %.3f |", name, t1 - t0, e.l1, e.rmse,
                e.log, e.cbrt, c.cpu_seconds);
    for (const auto& s : c.stages) std::printf(" %s %.4f %d %.3fs", s.name.c_str(), s.objective, s.iterations, s.cpu_seconds);
    std::printf(" agree %zu |", c.agreeing);
    for (const auto& [key, value] : result->material.specular[0].parameters)
      if (auto* n = std::get_if<std::vector<double>>(&value)) {
        std::printf(" %s", key.c_str());
        for (double x : *n) std::printf(" %.4g", x);
      }
    std::printf("\n");
  }
}
