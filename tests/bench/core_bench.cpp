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
#include <random>
#include <string>

#include "bench/cases.h"
#include "bench/core_table.h"
#include "engine/evaluate.h"
#include "engine/thread_pool.h"
#include "models/run.h"

namespace gonio::bench {
namespace {

// Directions over the hemisphere as separate components, with room so that arrays do not share
// cache sets.
struct Arrays {
  explicit Arrays(std::size_t n) : count(n) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform;
    for (auto& a : in) a.resize(n + 80);
    // Large batches have three channels.
    out.resize((n > kSpectralPairs ? 3 : kMaxChannels) * n + 80);
    out64.resize(3 * n + 80);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 6; k += 3) {
        const float z = uniform(random) * 0.999F + 0.001F, phi = 6.2831853F * uniform(random),
                    s = std::sqrt(1 - z * z);
        in[k][i] = s * std::cos(phi), in[k + 1][i] = s * std::sin(phi), in[k + 2][i] = z;
      }
    }
  }
  template <class Out>
  [[nodiscard]] Batch<float, Out> batch(std::vector<Out>& to) const {
    return {Directions<float>::separate(in[0].data(), in[1].data(), in[2].data()),
            Directions<float>::separate(in[3].data(), in[4].data(), in[5].data()), count,
            Values<Out>::planar(to.data(), count)};
  }
  std::size_t count;
  std::vector<float> in[6], out;
  std::vector<double> out64;
};

Arrays& arrays(std::size_t n) {
  static std::map<std::size_t, Arrays> all;
  return all.try_emplace(n, n).first->second;
}

void count_pairs(benchmark::State& state, std::size_t pairs) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs));
}

void memory_limit(benchmark::State& state, std::size_t n) {
  Arrays& a = arrays(n);
  for (auto _ : state) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float* x = a.in[c].data();
      const float* y = a.in[c + 3].data();
      float* to = a.out.data() + c * n;
      for (std::size_t i = 0; i < n; ++i) to[i] = x[i] + y[i];
    }
    benchmark::ClobberMemory();
  }
  count_pairs(state, n);
}

template <class T>
void scalar(benchmark::State& state, const BenchCase<T>& model) {
  const std::size_t n = 4096;
  Arrays& a = arrays(n);
  std::vector<T> out(3 * n);
  for (auto _ : state) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::array<T, 3> f = model.printed({T(a.in[0][i]), T(a.in[1][i]), T(a.in[2][i])},
                                               {T(a.in[3][i]), T(a.in[4][i]), T(a.in[5][i])});
      out[3 * i] = f[0], out[3 * i + 1] = f[1], out[3 * i + 2] = f[2];
    }
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  count_pairs(state, n);
}

void fast(benchmark::State& state, const Material& material, Isa isa, std::size_t n) {
  Arrays& a = arrays(n);
  const auto batch = a.batch(a.out);
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(material, batch, isa));
  count_pairs(state, n);
}

void reference(benchmark::State& state, const Material& material, Isa isa, std::size_t n) {
  Arrays& a = arrays(n);
  const auto batch = a.batch(a.out64);
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(material, batch, isa));
  count_pairs(state, n);
}

void two_threads(benchmark::State& state, const Material& material, std::size_t n) {
  static ThreadPool pool(1, 16);  // and the caller
  Arrays& a = arrays(n);
  const auto batch = a.batch(a.out);
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(material, batch, best_isa(), pool));
  count_pairs(state, n);
}

void register_model(const std::string& name, const MaterialSpec& spec) {
  const Material material = testing::material_of(spec);
  for (const Isa isa : supported_isas()) {
    for (const std::size_t n : kSizes) {
      const std::string at = "/" + std::string(name_of(isa)) + "/" + std::to_string(n);
      benchmark::RegisterBenchmark((name + "/fast" + at).c_str(), fast, material, isa, n);
      benchmark::RegisterBenchmark((name + "/reference" + at).c_str(), reference, material, isa, n);
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
    benchmark::RegisterBenchmark(name.c_str(), fast, testing::material_of(spec), best_isa(),
                                 kSpectralPairs);
  };
  for (const auto& model : bench_cases<float>()) add(model.name + kSpectral, spectral(model.spec));
  add(kSum, sum_of_lobes());
}

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) {
  using namespace gonio::bench;
  for (const std::size_t n : kSizes) {
    benchmark::RegisterBenchmark(("memory limit/" + std::to_string(n)).c_str(), memory_limit, n);
  }
  for (const auto& model : bench_cases<float>()) {
    benchmark::RegisterBenchmark((model.name + "/scalar float").c_str(), scalar<float>, model);
    register_model(model.name, model.spec);
  }
  register_combinations();
  for (const auto& model : bench_cases<double>()) {
    benchmark::RegisterBenchmark((model.name + "/scalar double").c_str(), scalar<double>, model);
  }
  Best best;
  run_all(argc, argv, best);
  print_table(best);
  return 0;
}
