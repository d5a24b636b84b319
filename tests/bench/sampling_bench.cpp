// Samplers in one run against a textbook's: speed (sample, pdf and weights together, against the
// same in a scalar float loop and against memory), and the variance of the weights.
//
//   sampling_bench                  the tables below, after Google Benchmark's own lines
//   sampling_bench --benchmark_filter=ggx
//
// Variances are over half a million scrambled Sobol' points, lost samples counting as 0.
#include <cstdio>
#include <map>
#include <memory>

#include "bench/best.h"
#include "chart/sampling_cases.h"
#include "chart/variance.h"
#include "gonio/engine/sampler.h"
#include "models/oracle/run.h"
#include "timing/samples.h"

namespace gonio::bench {
namespace {

using chart::BoundedCase, chart::SamplingCase, chart::ScalarSampling, chart::Variance,
    chart::Vector64;

constexpr std::size_t kSizes[] = {1000, 4096, 65536, std::size_t{1} << 20};

using Arrays = std::shared_ptr<timing::Samples>;

Arrays arrays(std::size_t n) {
  static std::map<std::size_t, Arrays> all;
  Arrays& found = all[n];
  if (!found) found = std::make_shared<timing::Samples>(n);
  return found;
}

void count_samples(benchmark::State& state, std::size_t n) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
}

// Six numbers read, seven written.
void memory_limit(benchmark::State& state, std::size_t n) {
  const Arrays a = arrays(n);
  for (auto _ : state) {
    for (std::size_t i = 0; i < 3 * n; ++i) a->wo[i] = a->weights[i] = a->wi[i] + a->xi[i];
    for (std::size_t i = 0; i < n; ++i) a->pdf[i] = 1;
    benchmark::ClobberMemory();
  }
  count_samples(state, n);
}

void scalar(benchmark::State& state, ScalarSampling run, std::size_t n) {
  const Arrays a = arrays(n);
  for (auto _ : state) {
    run(a->wi.data(), a->xi.data(), n, a->wo.data(), a->pdf.data(), a->weights.data());
    benchmark::ClobberMemory();
  }
  count_samples(state, n);
}

void fast(benchmark::State& state, const Sampler& sampler, Isa isa, std::size_t n, bool given) {
  const timing::Runner runner = timing::sampling(arrays(n), sampler, isa, given);
  for (auto _ : state) runner.run();
  count_samples(state, n);
}

void register_case(const SamplingCase& model) {
  const Sampler sampler = Sampler::create(testing::material_of(model.spec));
  benchmark::RegisterBenchmark((model.name + "/scalar float").c_str(), scalar, model.scalar, 4096);
  for (const Isa isa : supported_isas()) {
    for (const std::size_t n : kSizes) {
      benchmark::RegisterBenchmark(
          (model.name + "/" + std::string(name_of(isa)) + "/" + std::to_string(n)).c_str(), fast,
          sampler, isa, n, true);
    }
  }
  benchmark::RegisterBenchmark((model.name + "/own numbers").c_str(), fast, sampler, best_isa(),
                               4096, false);
}

void print_speed(const Best& best, const std::vector<SamplingCase>& cases) {
  std::printf("\n%-17s %-8s %6s %8s %8s   %s\n%-17s %-8s %6s %8s %8s   %4s %4s %4s\n", "", "", "ns",
              "x scalar", "of limit", "M samples/s of a batch of", "model", "isa", "(4096)",
              "float", "(1 M)", "1 k", "64 k", "1 M");
  for (const SamplingCase& model : cases) {
    for (const Isa isa : supported_isas()) {
      const std::string at = model.name + "/" + std::string(name_of(isa)) + "/";
      const double rate = best.rate(at + "4096");
      if (rate == 0) continue;
      std::printf("%-17s %-8s %6.2f %8.1f %8.2f   %4.0f %4.0f %4.0f\n", model.name.c_str(),
                  std::string(name_of(isa)).c_str(), 1e9 / rate,
                  rate / best.rate(model.name + "/scalar float"),
                  best.rate(at + "1048576") / best.rate("memory limit/1048576"),
                  best.rate(at + "1000") / 1e6, best.rate(at + "65536") / 1e6,
                  best.rate(at + "1048576") / 1e6);
    }
    if (const double own = best.rate(model.name + "/own numbers"); own > 0)
      std::printf("%-17s %-8s %6.2f   with numbers of its own\n", model.name.c_str(), "",
                  1e9 / own);
  }
}

void print_variances(const std::vector<SamplingCase>& cases) {
  std::printf("\nVariance of the weights, and samples lost:\n%-26s %5s   %9s %6s   %9s %6s\n",
              "material", "theta", "gonio", "lost", "textbook", "lost");
  const auto print = [](const SamplingCase& of, double theta, double azimuth, const char* after) {
    const Material material = testing::material_of(of.spec);
    const Vector64 wi = chart::direction(theta, azimuth);
    const Variance own = chart::own_variance(material, wi, {}),
                   book = chart::variance_of(of.draw, of.pdf, material, wi, {});
    std::printf("%-26s %2.0f/%-2.0f   %9.5f %6.3f   %9.5f %6.3f%s", of.name.c_str(), theta, azimuth,
                own.variance, own.lost, book.variance, book.lost, after);
  };
  for (const SamplingCase& of : cases) {
    for (const double theta : {10.0, 60.0, 75.0, 85.0}) print(of, theta, 0, "\n");
  }
  for (const BoundedCase& of : chart::bounded_cases()) {
    print(of.material, of.theta, of.azimuth, "");
    std::printf("   wanted %.3f\n", of.bound);
  }
}

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) {
  using namespace gonio::bench;
  const std::vector<gonio::chart::SamplingCase> cases = gonio::chart::timed_cases();
  for (const std::size_t n : kSizes) {
    benchmark::RegisterBenchmark(("memory limit/" + std::to_string(n)).c_str(), memory_limit, n);
  }
  for (const auto& model : cases) register_case(model);
  Best best;
  run_all(argc, argv, best);
  print_speed(best, cases);
  print_variances(cases);
  return 0;
}
