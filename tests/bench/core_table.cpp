#include "bench/core_table.h"

#include <cstdio>
#include <limits>

#include "bench/cases.h"
#include "models/harness/compare.h"
#include "models/oracle/run.h"

namespace gonio::bench {

namespace {

struct Accuracy {
  double worst, p999;
  std::string_view where;  // the worst is
};

// Relative errors within the stated range, over the oracle's hard pairs.
template <class Out>
Accuracy accuracy(const MaterialSpec& spec, Isa isa) {
  auto pairs = testing::hard_pairs<float>(1);
  std::erase_if(pairs, [](const auto& p) { return std::min(p.wi[2], p.wo[2]) < 1.001e-6F; });
  const auto truth = testing::oracle_values(testing::Oracle<testing::Quad>(spec), pairs);
  const std::vector<Out> got = testing::library_values<Out>(testing::material_of(spec), pairs, isa);
  const testing::Comparison result = testing::compare<Out>(got, truth, 1e-30);
  const std::size_t at = result.improper_at.value_or(result.worst_at);
  const auto kind = pairs[at / (got.size() / pairs.size())].kind;
  const double worst = result.improper_at ? std::numeric_limits<double>::infinity() : result.worst;
  return {worst, result.p999, testing::name_of(kind)};
}

template <class Out>
void print_row(const Best& best, const std::string& name, const MaterialSpec& spec,
               const char* precision, Isa isa) {
  const std::string at = name + "/" + precision + "/" + std::string(name_of(isa)) + "/";
  const double rate = best.rate(at + "4096");
  if (rate == 0) return;
  const Accuracy error = accuracy<Out>(spec, isa);
  std::printf(
      "%-17s %-9s %-8s %6.2f %8.1f %8.1f %8.2f %8.2f   %7.1e %7.1e %-12s   %4.0f %4.0f %4.0f\n",
      name.c_str(), precision, std::string(name_of(isa)).c_str(), 1e9 / rate,
      rate / best.rate(name + "/scalar float"), rate / best.rate(name + "/scalar double"),
      rate / best.rate("memory limit/4096"),
      best.rate(at + "1048576") / best.rate("memory limit/1048576"), error.worst, error.p999,
      std::string(error.where).c_str(), best.rate(at + "1000") / 1e6, best.rate(at + "10000") / 1e6,
      best.rate(at + "1048576") / 1e6);
}

void print_models(const Best& best) {
  std::printf("\n%-17s %-9s %-8s %6s %8s %8s %8s %8s   %7s %7s %-12s   %s\n", "", "", "", "ns",
              "x scalar", "x scalar", "of limit", "of limit", "error", "error", "the worst",
              "M pairs/s of a batch of");
  std::printf("%-17s %-9s %-8s %6s %8s %8s %8s %8s   %7s %7s %-12s   %4s %4s %4s\n", "model",
              "precision", "isa", "(4096)", "float", "double", "(4096)", "(1 M)", "worst", "99.9 %",
              "is at", "1 k", "10 k", "1 M");
  for (const auto& model : model_cases<float>()) {
    for (const Isa isa : supported_isas()) {
      print_row<float>(best, model.name, model.spec, "fast", isa);
      print_row<double>(best, model.name, model.spec, "reference", isa);
    }
  }
}

void print_threads(const Best& best) {
  std::printf("\n2 threads over 1, on the best instruction set:\n");
  for (const auto& model : model_cases<float>()) {
    const std::string at = model.name + "/fast/" + std::string(name_of(best_isa())) + "/";
    std::printf("  %-17s", model.name.c_str());
    for (const std::size_t n : kSizes) {
      const std::string size = std::to_string(n);
      std::printf("  %s: %.2f", size.c_str(),
                  best.rate(model.name + "/2 threads/" + size) / best.rate(at + size));
    }
    std::printf("\n");
  }
}

// Time, relative to what it is compared with.
void print_combinations(const Best& best) {
  const auto three_channels = [&](const std::string& name) {
    return best.rate(name + "/fast/" + std::string(name_of(best_isa())) + "/" +
                     std::to_string(kSpectralPairs));
  };
  std::printf("\nTime of 64 channels over that of 3, batches of %zu:\n", kSpectralPairs);
  for (const auto& model : model_cases<float>()) {
    std::printf("  %-17s  %.2f\n", model.name.c_str(),
                three_channels(model.name) / best.rate(model.name + kSpectral));
  }
  double parts = 0;
  for (const std::string& name : summed_lobes()) parts += 1 / three_channels(name);
  std::printf("\nTime of a sum of four lobes over that of its parts: %.2f\n",
              1 / best.rate(kSum) / parts);
}

}  // namespace

void print_table(const Best& best) {
  print_models(best);
  print_threads(best);
  print_combinations(best);
}

}  // namespace gonio::bench
