#include "client/picture/render/integrator.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "client/picture/render/film.h"
#include "client/picture/render/parallel.h"

namespace gonio::render {
namespace {

constexpr std::size_t kBatch = 65536;  // camera samples; as many pairs in a call, at most
constexpr std::size_t kRun = 2048;     // camera samples, or points, that a thread takes at a time

// What numbers are drawn for.
enum Purpose : std::uint32_t { film = 0, light_direction = 1, surface_direction = 2 };

// A camera sample that meets the object.
struct Point {
  Frame frame;
  Vec3f viewer;          // local
  std::uint32_t sample;  // its number in the batch
  Sequence sequence;
  std::uint32_t index;  // in its pixel
};

// Per point of a batch.
struct Directions {
  std::vector<float> lights, pdf;  // local, and the surface's density
  std::vector<Rgb> values;
  void resize(std::size_t points) {
    lights.resize(3 * points), pdf.resize(points), values.resize(points);
  }
};

Vec3f at(const std::vector<float>& directions, std::size_t i) {
  return {directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]};
}

class Batch {
 public:
  Batch(const Scene& scene, const Sampling& sampling, Surface& surface)
      : scene_(scene), sampling_(sampling), surface_(surface) {}

  // The radiance of camera samples first ... first + count - 1, which are numbered pixel after
  // pixel.
  Outcome trace(std::uint64_t first, std::size_t count) {
    radiance_.assign(count, Rgb::Zero());
    find_points(first, count);
    if (uses_light()) {
      if (auto done = from_light(); !done) return done;
    }
    return uses_surface() ? from_surface() : Ok{};
  }
  [[nodiscard]] const std::vector<Rgb>& radiance() const { return radiance_; }

 private:
  void find_points(std::uint64_t first, std::size_t count) {
    std::vector<std::vector<Point>> runs((count + kRun - 1) / kRun);
    parallel_for(runs.size(), sampling_.threads, [&](std::size_t run) {
      for (std::size_t i = run * kRun; i < std::min(count, (run + 1) * kRun); ++i)
        look(first + i, i, runs[run]);
    });
    points_.clear();
    viewers_.clear();
    for (const auto& run : runs) {
      for (const Point& point : run) {
        points_.push_back(point);
        viewers_.insert(viewers_.end(), point.viewer.begin(), point.viewer.end());
      }
    }
    directions_.resize(points_.size());
  }

  void look(std::uint64_t number, std::size_t place, std::vector<Point>& points) {
    const auto samples = static_cast<std::uint64_t>(sampling_.samples);
    const auto width = static_cast<std::uint64_t>(sampling_.width);
    const std::uint64_t pixel = number / samples;
    const auto index = static_cast<std::uint32_t>(number % samples);
    const Sequence sequence(sampling_.seed, static_cast<std::uint32_t>(pixel));
    const Xi jitter = sequence.draw(index, Purpose::film);
    const std::uint64_t column = pixel % width, row = pixel / width;
    const Ray ray = scene_.camera.ray(static_cast<double>(column) + jitter[0],
                                      static_cast<double>(row) + jitter[1]);
    const auto frame = scene_.shape.hit(ray);
    if (!frame) {
      radiance_[place] =
          scene_.background ? *scene_.background : scene_.light.radiance(ray.direction);
      return;
    }
    const Vec3f viewer = frame->to_local(-ray.direction);
    if (viewer.z() > 0)
      points.push_back({*frame, viewer, static_cast<std::uint32_t>(place), sequence, index});
  }

  template <class Body>
  void for_points(const Body& body) {
    parallel_for((points_.size() + kRun - 1) / kRun, sampling_.threads, [&](std::size_t run) {
      for (std::size_t i = run * kRun; i < std::min(points_.size(), (run + 1) * kRun); ++i) body(i);
    });
  }

  // A single direction is never drawn by chance.
  [[nodiscard]] bool uses_light() const {
    return scene_.light.single_direction() || sampling_.technique != Technique::surface;
  }
  [[nodiscard]] bool uses_surface() const {
    return !scene_.light.single_direction() && sampling_.technique != Technique::light;
  }
  // The sum of the densities of the techniques in use, of a direction that the light has with
  // `light` and the surface with `surface`.
  [[nodiscard]] double density(double light, float surface) const {
    return (uses_light() ? light : 0) + (uses_surface() ? static_cast<double>(surface) : 0);
  }

  Outcome from_light() {
    Directions& d = directions_;
    lit_.resize(points_.size());
    for_points([&](std::size_t i) {
      const Point& point = points_[i];
      Vec3f local = point.frame.to_local(
          scene_.light.sample(point.sequence.draw(point.index, light_direction)));
      // Light from below is not asked about.
      lit_[i] = local.z() > 0 ? 1 : 0;
      if (lit_[i] == 0) local = Vec3f::UnitZ();
      std::copy(local.begin(), local.end(), d.lights.begin() + static_cast<std::ptrdiff_t>(3 * i));
    });
    const std::span<float> pdf = uses_surface() ? std::span(d.pdf) : std::span<float>();
    if (auto done = surface_.evaluate(viewers_, d.lights, d.values, pdf); !done) return done;
    for_points([&](std::size_t i) {
      if (lit_[i] == 0) return;
      const Vec3f local = at(d.lights, i);
      const Vec3 world = points_[i].frame.to_world(local);
      const double sum = density(scene_.light.density(world), d.pdf[i]);
      if (sum > 0)
        radiance_[points_[i].sample] += scene_.light.radiance(world) * d.values[i] *
                                        static_cast<float>(static_cast<double>(local.z()) / sum);
    });
    return Ok{};
  }

  Outcome from_surface() {
    Directions& d = directions_;
    xi_.resize(3 * points_.size());
    for_points([&](std::size_t i) {
      const Point& point = points_[i];
      const Xi uv = point.sequence.draw(point.index, surface_direction);
      const double which = point.sequence.draw_third(point.index, surface_direction);
      // Rounding to float32 must not reach 1.
      const auto number = [](double x) { return std::min(static_cast<float>(x), 0x1.fffffep-1F); };
      xi_[3 * i] = number(which), xi_[3 * i + 1] = number(uv[0]), xi_[3 * i + 2] = number(uv[1]);
    });
    if (auto done = surface_.sample(viewers_, xi_, d.lights, d.pdf, d.values); !done) return done;
    for_points([&](std::size_t i) {
      const float pdf = d.pdf[i];
      if (!(pdf > 0)) return;
      const Vec3 world = points_[i].frame.to_world(at(d.lights, i));
      const double share = static_cast<double>(pdf) / density(scene_.light.density(world), pdf);
      radiance_[points_[i].sample] +=
          scene_.light.radiance(world) * d.values[i] * static_cast<float>(share);
    });
    return Ok{};
  }

  const Scene& scene_;
  const Sampling& sampling_;
  Surface& surface_;
  std::vector<Rgb> radiance_;  // of each sample, the background at first
  std::vector<Point> points_;
  std::vector<float> viewers_, xi_;
  std::vector<std::uint8_t> lit_;  // whether the light's direction is above the horizon
  Directions directions_;
};

}  // namespace

Result<image::Image> render(const Scene& scene, const Sampling& sampling, Surface& surface,
                            const OnProgress& on_progress) {
  const std::uint64_t total = static_cast<std::uint64_t>(sampling.width) *
                              static_cast<std::uint64_t>(sampling.height) *
                              static_cast<std::uint64_t>(sampling.samples);
  Film film(sampling.width, sampling.height, sampling.samples);
  Batch batch(scene, sampling, surface);
  for (std::uint64_t first = 0; first < total; first += kBatch) {
    const std::size_t count = std::min<std::uint64_t>(kBatch, total - first);
    if (auto done = batch.trace(first, count); !done) return done.error();
    for (const Rgb& radiance : batch.radiance()) film.add(radiance);
    on_progress(static_cast<double>(first + count) / static_cast<double>(total));
  }
  return film.take();
}

}  // namespace gonio::render
