// Strategies of sampling: time against the variance of the weights.
#include <array>
#include <numeric>

#include "chart/chart.h"
#include "chart/common.h"
#include "chart/sampling_cases.h"
#include "chart/variance.h"
#include "timing/samples.h"

namespace gonio::chart {
namespace {

constexpr std::array kAngles{30.0, 75.0};
constexpr std::uint64_t kSeeds = 5;

using SharedSamples = std::shared_ptr<timing::Samples>;

// Cosine-weighted directions, evaluated by the material's own kernels.
timing::Runner by_cosine(const SharedSamples& samples, const Material& material) {
  const Sampler cosine = Sampler::create(
      *Material::create(alone({"lambertian", {{"rd", std::vector<double>{0.5, 0.5, 0.5}}}})));
  const auto run = [samples, cosine, material] {
    timing::Samples& s = *samples;
    SampleBatch<float> batch = s.batch(true);
    batch.weights = {};
    (void)sample(cosine, batch, best_isa());
    evaluate(material,
             Batch<float, float>{Directions<float>::interleaved(s.wi.data()),
                                 Directions<float>::interleaved(s.wo.data()), s.count,
                                 Values<float>::interleaved(s.weights.data(), 3), nullptr},
             best_isa());
    for (std::size_t i = 0; i < s.count; ++i) {
      const float factor = s.pdf[i] > 0 ? s.wo[3 * i + 2] / s.pdf[i] : 0;
      for (std::size_t c = 0; c < 3; ++c) s.weights[3 * i + c] *= factor;
    }
  };
  return {run, static_cast<double>(samples->count)};
}

timing::Runner by_textbook(const SharedSamples& samples, ScalarSampling scalar) {
  const auto run = [samples, scalar] {
    timing::Samples& s = *samples;
    scalar(s.wi.data(), s.xi.data(), s.count, s.wo.data(), s.pdf.data(), s.weights.data());
  };
  return {run, static_cast<double>(samples->count)};
}

// The variance divided by the squared mean, for several sets of numbers.
template <class Find>
timing::Spread relative_variances(const Find& find, double& lost) {
  std::vector<double> found;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Variance variance = find(VarianceEffort{std::size_t{1} << 14U, seed});
    found.push_back(variance.variance / (variance.mean * variance.mean));
    lost = variance.lost;
  }
  return timing::spread_of(found);
}

struct Strategy {
  std::string name;
  timing::Runner runner;
  std::function<Variance(const Vector64& wi, const VarianceEffort&)> variance;
};

std::vector<Strategy> strategies_of(const SamplingCase& of, const SharedSamples& samples) {
  const Material material = *Material::create(of.spec);
  const Cosine<double> cosine;
  const auto drawn = [material](const DrawFunction& draw, const PdfFunction& pdf) {
    return [=](const Vector64& wi, const VarianceEffort& effort) {
      return variance_of(draw, pdf, material, wi, effort);
    };
  };
  return {{"gonio", timing::sampling(samples, Sampler::create(material), best_isa(), true),
           [material](const Vector64& wi, const VarianceEffort& effort) {
             return own_variance(material, wi, effort);
           }},
          {"cosine", by_cosine(samples, material),
           drawn([cosine](const Vector64& wi, const Vector64& xi) { return cosine.draw(wi, xi); },
                 [cosine](const Vector64& wi, const Vector64& wo) { return cosine.pdf(wi, wo); })},
          {"textbook", by_textbook(samples, of.scalar), drawn(of.draw, of.pdf)}};
}

Table empty_table() {
  Table table{"sampling",
              "Strategies of sampling: ns a sample against the variance of the weights",
              {{"model", "", "a material of this model"},
               {"strategy", "",
                "gonio: its own; cosine: gonio's kernels, drawn by the cosine; textbook: a scalar "
                "loop in float32"},
               {"theta", "deg", "of incidence"},
               {"group", "", "model and angle"}},
              {}};
  add_time_columns(table, "ns", "ns",
                   "time of one sample with density and weight, the best instruction set");
  table.columns.push_back({"variance", "1", "of the weights over their mean's square, the median"});
  table.columns.push_back({"variance_lower", "1", "lower quartile over sets of random numbers"});
  table.columns.push_back({"variance_upper", "1", "their upper quartile"});
  table.columns.push_back({"lost", "1", "the part of samples below the horizon"});
  table.columns.push_back(
      {"us_to_1_percent", "us", "ns x variance / 0.01^2: until the mean's standard error is 1 %"});
  return table;
}

}  // namespace

Result<Table> chart_sampling(const Options& options) {
  const auto samples = std::make_shared<timing::Samples>(timing::kTimedPairs);
  const std::vector<SamplingCase> cases = timed_cases();
  std::vector<std::vector<Strategy>> strategies;
  std::vector<timing::Runner> runners;
  for (const SamplingCase& of : cases) {
    strategies.push_back(strategies_of(of, samples));
    for (const Strategy& strategy : strategies.back()) runners.push_back(strategy.runner);
  }
  const auto seconds = timing::race(runners, options.effort, options.stop);
  Table table = empty_table();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (is_over(options)) return was_cancelled();
    show(options, 0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(cases.size()));
    for (std::size_t k = 0; k < strategies[i].size(); ++k) {
      for (const double theta : kAngles) {
        double lost = 0;
        const timing::Spread variance = relative_variances(
            [&](const VarianceEffort& effort) {
              return strategies[i][k].variance(direction(theta, 0), effort);
            },
            lost);
        const timing::Spread ns = scaled(seconds[i * strategies[i].size() + k], 1e9);
        std::vector<Cell> row{cases[i].name, strategies[i][k].name, theta,
                              cases[i].name + " at " + std::to_string(static_cast<int>(theta))};
        add_time_cells(row, ns);
        for (const double x : {variance.median, variance.lower, variance.upper, lost,
                               ns.best * variance.median * 1e4 * 1e-3})
          row.emplace_back(x);
        table.rows.push_back(std::move(row));
      }
    }
  }
  add_front(table, "ns", "variance", "group");
  show(options, 1);
  return table;
}

}  // namespace gonio::chart
