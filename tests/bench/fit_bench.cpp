// Fits of measured materials: how good, how fast, how robust. See kModes.
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "fit_modes.h"

namespace gonio::bench {

fit::Data load(const std::string& name, double noise, double invalid) {
  auto data = testing::load_measured(name, noise, invalid);
  if (!data) {
    std::fprintf(stderr, "fit_bench: no material '%s' in %s\n", name.c_str(),
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

namespace {

struct Mode {
  const char *name, *what;
  int standard;  // the optional number's
  std::function<bool(int)> run;
};

const std::array kModes{
    Mode{"published", "two models x eight materials x four metrics at theta <= 80 degrees", 0,
         [](int) { return compare_with_published(); }},
    Mode{"starts", "ends of N random starts, four models x twelve data sets", 50,
         print_independence},
    Mode{"time", "CPU time on 20,000 pairs, the best of N, and polished on all", 3, print_times},
    Mode{"noise", "fits of noisy data judged on clean ones", 0, [](int) { return print_noise(); }},
    Mode{"coverage", "how many of N trials' intervals cover the truth", 400, print_coverage},
    Mode{"grazing", "errors by zone of fits of each zone; which lobe is it?", 0,
         [](int) { return print_grazing(); }},
};

int usage() {
  std::fputs("usage: fit_bench MODE [N]\n", stderr);
  for (const Mode& mode : kModes) std::fprintf(stderr, "  %-10s %s\n", mode.name, mode.what);
  return 2;
}

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  for (const auto& mode : gonio::bench::kModes) {
    if (name == mode.name)
      return mode.run(argc > 2 ? std::max(std::atoi(argv[2]), 1) : mode.standard) ? 0 : 1;
  }
  return gonio::bench::usage();
}
