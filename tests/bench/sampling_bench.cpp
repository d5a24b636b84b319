// Samplers in one run against a textbook's: speed (sample, pdf and weights together, against the
// same in a scalar float loop and against memory), and the variance of the weights.
//
//   sampling_bench                  the tables below, after Google Benchmark's own lines
//   sampling_bench --benchmark_filter=ggx
//
// Variances are over half a million scrambled Sobol' points, lost samples counting as 0.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "bench/best.h"
#include "chart/sampling_cases.h"
#include "engine/sampler.h"
#include "models/run.h"

namespace gonio::bench {
namespace {

using chart::BoundedCase, chart::SamplingCase, chart::ScalarSampling, chart::Vector64;

constexpr std::size_t kSizes[] = {1000, 4096, 65536, std::size_t{1} << 20};

// Triples, as they come over the wire.
struct Arrays {
  explicit Arrays(std::size_t n)
      : count(n), wi(3 * n), xi(3 * n), wo(3 * n), weights(3 * n), pdf(n) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform;
    for (std::size_t i = 0; i < n; ++i) {
      const float z = uniform(random) * 0.999F + 0.001F, phi = 6.2831853F * uniform(random),
                  s = std::sqrt(1 - z * z);
      wi[3 * i] = s * std::cos(phi), wi[3 * i + 1] = s * std::sin(phi), wi[3 * i + 2] = z;
      for (std::size_t c = 0; c < 3; ++c) xi[3 * i + c] = std::min(uniform(random), 0.9999999F);
    }
  }
  std::size_t count;
  std::vector<float> wi, xi, wo, weights, pdf;
};

Arrays& arrays(std::size_t n) {
  static std::map<std::size_t, Arrays> all;
  return all.try_emplace(n, n).first->second;
}

void count_samples(benchmark::State& state, std::size_t n) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
}

// Six numbers read, seven written.
void memory_limit(benchmark::State& state, std::size_t n) {
  Arrays& a = arrays(n);
  for (auto _ : state) {
    for (std::size_t i = 0; i < 3 * n; ++i) a.wo[i] = a.weights[i] = a.wi[i] + a.xi[i];
    for (std::size_t i = 0; i < n; ++i) a.pdf[i] = 1;
    benchmark::ClobberMemory();
  }
  count_samples(state, n);
}

void scalar(benchmark::State& state, ScalarSampling run, std::size_t n) {
  Arrays& a = arrays(n);
  for (auto _ : state) {
    run(a.wi.data(), a.xi.data(), n, a.wo.data(), a.pdf.data(), a.weights.data());
    benchmark::ClobberMemory();
  }
  count_samples(state, n);
}

void fast(benchmark::State& state, const Sampler& sampler, Isa isa, std::size_t n, bool given) {
  Arrays& a = arrays(n);
  SampleBatch<float> batch;
  batch.wi = Directions<float>::interleaved(a.wi.data());
  batch.count = n;
  if (given) batch.xi = a.xi.data();
  batch.wo = a.wo.data();
  batch.pdf = a.pdf.data();
  batch.weights = Values<float>::interleaved(a.weights.data(), 3);
  for (auto _ : state) benchmark::DoNotOptimize(sample(sampler, batch, isa));
  count_samples(state, n);
}

struct Variance {
  double variance, lost;
};

Vector64 direction(double theta, double azimuth) {
  const double t = theta * std::numbers::pi / 180, p = azimuth * std::numbers::pi / 180;
  return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

// Of the mean over the channels.
Variance variance_of(const std::vector<double>& weights, int channels, double lost) {
  const std::size_t n = weights.size() / static_cast<std::size_t>(channels);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double weight = 0;
    for (int c = 0; c < channels; ++c)
      weight += weights[i * static_cast<std::size_t>(channels) + static_cast<std::size_t>(c)];
    weight /= channels;
    sum += weight, squares += weight * weight;
  }
  const double mean = sum / static_cast<double>(n);
  return {squares / static_cast<double>(n) - mean * mean, lost / static_cast<double>(n)};
}

constexpr std::size_t kPoints = std::size_t{1} << 19;

Variance own_variance(const Material& material, const Vector64& wi) {
  const Sampler sampler = Sampler::create(material);
  std::vector<double> wo(3 * kPoints), pdf(kPoints);
  std::vector<double> weights(kPoints * static_cast<std::size_t>(material.channels()));
  SampleBatch<double> batch;
  batch.wi = Directions<double>::interleaved(wi.data());
  batch.count = batch.per_wi = kPoints;
  batch.numbers = {Sequence::sobol, 1};
  batch.wo = wo.data();
  batch.pdf = pdf.data();
  batch.weights = Values<double>::interleaved(weights.data(), material.channels());
  const SampleReport report = sample(sampler, batch, best_isa());
  return variance_of(weights, material.channels(), static_cast<double>(report.lost));
}

// The textbook's directions and densities with the library's own f.
Variance textbook_variance(const SamplingCase& of, const Material& material, const Vector64& wi) {
  std::vector<double> u[3], wis(3 * kPoints), wo(3 * kPoints), factor(kPoints);
  for (auto& x : u) x.resize(kPoints);
  random_numbers({Sequence::sobol, 1}, 0, kPoints, kPoints,
                 {u[0].data(), u[1].data(), u[2].data()});
  double lost = 0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const Vector64 out = of.draw(wi, {u[0][i], u[1][i], u[2][i]});
    for (std::size_t c = 0; c < 3; ++c) wis[3 * i + c] = wi[c], wo[3 * i + c] = out[c];
    const double pdf = of.pdf(wi, out);
    lost += out[2] > 0 ? 0 : 1;
    factor[i] = pdf > 0 ? std::max(out[2], 0.0) / pdf : 0;
  }
  const auto channels = static_cast<std::size_t>(material.channels());
  std::vector<double> weights(kPoints * channels);
  evaluate(material,
           Batch<double, double>{Directions<double>::interleaved(wis.data()),
                                 Directions<double>::interleaved(wo.data()), kPoints,
                                 Values<double>::interleaved(weights.data(), material.channels()),
                                 nullptr},
           best_isa());
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] *= factor[i / channels];
  return variance_of(weights, material.channels(), lost);
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
    const Vector64 wi = direction(theta, azimuth);
    const Variance own = own_variance(material, wi), book = textbook_variance(of, material, wi);
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
