#include "client/render/integrator.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "client/render/film.h"
#include "client/render/parallel.h"
#include "client/render/strategy.h"

namespace gonio::render {
namespace {

constexpr std::size_t kBatch =
    65536;                          // camera samples; with two strategies, 131072 pairs in a call
constexpr std::size_t kRun = 2048;  // camera samples that a thread takes at a time

using Strategies = std::vector<std::unique_ptr<const Strategy>>;

// A run of camera samples: what they see, and what has to be evaluated for it.
struct Run {
  std::vector<Rgb> radiance;           // of each sample, the background at first
  std::vector<std::uint32_t> samples;  // of each pair, its number in `radiance`
  std::vector<Rgb> weights;            // of each pair: radiance times cosine by density
  std::vector<float> wi, wo;           // of each pair, interleaved
  Outcome outcome = Ok{};
};

// The samples of a run that meet the object.
struct Points {
  std::vector<Point> points;
  std::vector<std::uint32_t> samples;  // their numbers in the run
  std::vector<std::pair<Sequence, std::uint32_t>> draws;
};

class Tracer {
 public:
  Tracer(const Scene& scene, const Sampling& sampling, const Strategies& strategies)
      : scene_(scene), sampling_(sampling), strategies_(strategies) {}

  [[nodiscard]] Run trace(std::uint64_t first, std::size_t count) const {
    Run run;
    run.radiance.assign(count, Rgb::Zero());
    Points points;
    for (std::size_t i = 0; i < count; ++i) look(first + i, i, run, points);
    for (std::size_t k = 0; k < strategies_.size() && run.outcome; ++k) {
      run.outcome = gather(k, points, run);
    }
    return run;
  }

 private:
  // Samples are numbered pixel after pixel.
  void look(std::uint64_t number, std::size_t place, Run& run, Points& points) const {
    const auto samples = static_cast<std::uint64_t>(sampling_.samples);
    const auto width = static_cast<std::uint64_t>(sampling_.width);
    const std::uint64_t pixel = number / samples;
    const auto sample = static_cast<std::uint32_t>(number % samples);
    const Sequence sequence(sampling_.seed, static_cast<std::uint32_t>(pixel));
    const Xi jitter = sequence.draw(sample, kFilm);
    const std::uint64_t column = pixel % width, row = pixel / width;
    const Ray ray = scene_.camera.ray(static_cast<double>(column) + jitter[0],
                                      static_cast<double>(row) + jitter[1]);
    const auto frame = scene_.shape.hit(ray);
    if (!frame) {
      run.radiance[place] =
          scene_.background ? *scene_.background : scene_.light.radiance(ray.direction);
      return;
    }
    const Vec3f wo = frame->to_local(-ray.direction);
    if (!(wo.z() > 0)) return;
    points.points.push_back({*frame, wo});
    points.samples.push_back(static_cast<std::uint32_t>(place));
    points.draws.emplace_back(sequence, sample);
  }

  // Adds to the run one direction a point of strategy k.
  Outcome gather(std::size_t k, const Points& points, Run& run) const {
    const std::size_t count = points.points.size();
    std::vector<Xi> xi;
    xi.reserve(count);
    for (const auto& [sequence, sample] : points.draws) {
      xi.push_back(sequence.draw(sample, kFirstStrategy + static_cast<std::uint32_t>(k)));
    }
    std::vector<Vec3f> wi(count);
    if (auto done = strategies_[k]->propose(points.points, xi, wi); !done) return done;
    std::vector<double> sum(count), density(count);
    for (const auto& strategy : strategies_) {
      if (auto done = strategy->densities(points.points, wi, density); !done) return done;
      std::transform(sum.begin(), sum.end(), density.begin(), sum.begin(), std::plus<>());
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!(wi[i].z() > 0) || !(sum[i] > 0)) continue;
      const Point& point = points.points[i];
      const Rgb light = scene_.light.radiance(point.frame.to_world(wi[i]));
      run.samples.push_back(points.samples[i]);
      run.weights.emplace_back(light * static_cast<float>(wi[i].z() / sum[i]));
      run.wi.insert(run.wi.end(), wi[i].begin(), wi[i].end());
      run.wo.insert(run.wo.end(), point.wo.begin(), point.wo.end());
    }
    return Ok{};
  }

  static constexpr std::uint32_t kFilm = 0, kFirstStrategy = 1;  // what numbers are drawn for

  const Scene& scene_;
  const Sampling& sampling_;
  const Strategies& strategies_;
};

// Has the pairs of all runs evaluated in one call and adds what they bring to their samples.
Outcome shade(std::vector<Run>& runs, Evaluator& evaluator) {
  std::vector<float> wi, wo;
  for (const Run& run : runs) {
    if (!run.outcome) return run.outcome;
    wi.insert(wi.end(), run.wi.begin(), run.wi.end());
    wo.insert(wo.end(), run.wo.begin(), run.wo.end());
  }
  if (wi.empty()) return Ok{};
  std::vector<Rgb> values(wi.size() / 3);
  if (auto done = evaluator.evaluate(wi, wo, values); !done) return done;
  auto value = values.cbegin();
  for (Run& run : runs) {
    for (std::size_t i = 0; i < run.samples.size(); ++i) {
      run.radiance[run.samples[i]] += *value++ * run.weights[i];
    }
  }
  return Ok{};
}

}  // namespace

Result<image::Image> render(const Scene& scene, const Sampling& sampling, Evaluator& evaluator,
                            const OnProgress& on_progress) {
  const Strategies strategies = strategies_for(scene.light);
  const Tracer tracer(scene, sampling, strategies);
  const std::uint64_t total = static_cast<std::uint64_t>(sampling.width) *
                              static_cast<std::uint64_t>(sampling.height) *
                              static_cast<std::uint64_t>(sampling.samples);
  Film film(sampling.width, sampling.height, sampling.samples);
  for (std::uint64_t first = 0; first < total; first += kBatch) {
    const std::size_t count = std::min<std::uint64_t>(kBatch, total - first);
    std::vector<Run> runs((count + kRun - 1) / kRun);
    parallel_for(runs.size(), sampling.threads, [&](std::size_t i) {
      runs[i] = tracer.trace(first + i * kRun, std::min(kRun, count - i * kRun));
    });
    if (auto done = shade(runs, evaluator); !done) return done.error();
    for (const Run& run : runs) {
      for (const Rgb& radiance : run.radiance) film.add(radiance);
    }
    on_progress(static_cast<double>(first + count) / static_cast<double>(total));
  }
  return film.take();
}

}  // namespace gonio::render
