// Speed and accuracy of the kernels in one run: every model on every instruction set against its
// scalar form as printed (float and double), against the memory limit (six arrays added into
// three), and against the oracle.
//
//   core_bench                      the table below, after Google Benchmark's own lines
//   core_bench --benchmark_filter=ggx
//
// Repetitions of all benchmarks are interleaved at random and the best of each counts: the machine
// may be busy, but it is seldom busy throughout.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include "bench/cases.h"
#include "bench/core_table.h"
#include "gonio/engine/evaluate.h"
#include "gonio/engine/thread_pool.h"
#include "models/oracle/run.h"
#include "timing/pairs.h"

namespace gonio::bench {
namespace {

using Arrays = std::shared_ptr<timing::Pairs>;

Arrays arrays(std::size_t n) {
  static std::map<std::size_t, Arrays> all;
  Arrays& found = all[n];
  // Large batches have three channels.
  if (!found) found = std::make_shared<timing::Pairs>(n, n > kSpectralPairs ? 3 : kMaxChannels);
  return found;
}

void count_pairs(benchmark::State& state, std::size_t pairs) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs));
}

void memory_limit(benchmark::State& state, std::size_t n) {
  const Arrays a = arrays(n);
  float* out = a->fast().values.data;
  for (auto _ : state) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float* x = a->component(c);
      const float* y = a->component(c + 3);
      float* to = out + c * n;
      for (std::size_t i = 0; i < n; ++i) to[i] = x[i] + y[i];
    }
    benchmark::ClobberMemory();
  }
  count_pairs(state, n);
}

template <class T>
void scalar(benchmark::State& state, const ModelCase<T>& model) {
  const timing::Runner runner = chart::printed_evaluation<T>(arrays(4096), model.printed);
  for (auto _ : state) runner.run();
  count_pairs(state, 4096);
}

void kernel(benchmark::State& state, const Material& material, Precision precision, Isa isa,
            std::size_t n) {
  const timing::Runner runner = timing::evaluation(arrays(n), material, precision, isa);
  for (auto _ : state) runner.run();
  count_pairs(state, n);
}

void two_threads(benchmark::State& state, const Material& material, std::size_t n) {
  static ThreadPool pool(1, 16);  // and the caller
  const Arrays a = arrays(n);
  const auto batch = a->fast();
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(material, batch, best_isa(), pool));
  count_pairs(state, n);
}

void register_model(const std::string& name, const MaterialSpec& spec) {
  const Material material = testing::material_of(spec);
  for (const Isa isa : supported_isas()) {
    for (const std::size_t n : kSizes) {
      const std::string at = "/" + std::string(name_of(isa)) + "/" + std::to_string(n);
      benchmark::RegisterBenchmark((name + "/fast" + at).c_str(), kernel, material, Precision::fast,
                                   isa, n);
      benchmark::RegisterBenchmark((name + "/reference" + at).c_str(), kernel, material,
                                   Precision::reference, isa, n);
    }
  }
  for (const std::size_t n : kSizes) {
    benchmark::RegisterBenchmark((name + "/2 threads/" + std::to_string(n)).c_str(), two_threads,
                                 material, n)
        ->UseRealTime();
  }
}

void register_combinations() {
  const auto add = [](const std::string& name, const MaterialSpec& spec) {
    benchmark::RegisterBenchmark(name.c_str(), kernel, testing::material_of(spec), Precision::fast,
                                 best_isa(), kSpectralPairs);
  };
  for (const auto& model : model_cases<float>()) add(model.name + kSpectral, spectral(model.spec));
  add(kSum, sum_of_lobes());
}

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) {
  using namespace gonio::bench;
  for (const std::size_t n : kSizes) {
    benchmark::RegisterBenchmark(("memory limit/" + std::to_string(n)).c_str(), memory_limit, n);
  }
  for (const auto& model : model_cases<float>()) {
    benchmark::RegisterBenchmark((model.name + "/scalar float").c_str(), scalar<float>, model);
    register_model(model.name, model.spec);
  }
  register_combinations();
  for (const auto& model : model_cases<double>()) {
    benchmark::RegisterBenchmark((model.name + "/scalar double").c_str(), scalar<double>, model);
  }
  Best best;
  run_all(argc, argv, best);
  print_table(best);
  return 0;
}
