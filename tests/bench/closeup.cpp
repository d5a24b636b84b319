// Figure 6 of Ashikhmin & Shirley 2000 as a measurement: the error of a close-up of brushed metal
// against samples and against time, drawn from by gonio's strategy and by the paper's own.
//
//   closeup [SIZE]      writes CSV: strategy, samples a pixel, seconds, root of the mean squared
//                       error over the mean
//
// Both draw from the surface alone, as in the paper, and share camera, light and evaluations; the
// truth is gonio's picture with many samples of surface and light. Seconds are of the whole
// picture, at best of three.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "chart/textbook.h"
#include "client/cli/connection/connection.h"
#include "client/picture/render/evaluator.h"
#include "client/picture/render/integrator.h"
#include "client/picture/render/sky.h"

namespace gonio::bench {
namespace {

using image::Image;
using image::Rgb;

constexpr float kNu = 10, kNv = 100;

// The paper's section 3 as printed, but for its errata: half-vectors by equations 6 to 8, the
// evaluations the service's.
class Paper : public render::Surface {
 public:
  explicit Paper(render::Evaluator& evaluator) : evaluator_(evaluator) {}

  Outcome evaluate(std::span<const float> viewers, std::span<const float> lights, std::span<Rgb> f,
                   std::span<float> pdf) override {
    if (auto done = evaluator_.evaluate(viewers, lights, f, pdf); !done) return done;
    for (std::size_t i = 0; i < pdf.size(); ++i)
      pdf[i] = strategy_.pdf(at(viewers, i), at(lights, i));
    return Ok{};
  }

  Outcome sample(std::span<const float> viewers, std::span<const float> xi, std::span<float> lights,
                 std::span<float> pdf, std::span<Rgb> weights) override {
    std::vector<bool> lost(pdf.size());
    for (std::size_t i = 0; i < pdf.size(); ++i) {
      chart::Vector<float> light = strategy_.draw(at(viewers, i), at(xi, i));
      lost[i] = !(light[2] > 0);
      if (lost[i]) light = {0, 0, 1};
      std::copy(light.begin(), light.end(), lights.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
    if (auto done = evaluate(viewers, lights, weights, pdf); !done) return done;
    for (std::size_t i = 0; i < pdf.size(); ++i) {
      if (lost[i]) pdf[i] = 0;
      weights[i] *= pdf[i] > 0 ? lights[3 * i + 2] / pdf[i] : 0.0F;
    }
    return Ok{};
  }

 private:
  static chart::Vector<float> at(std::span<const float> triples, std::size_t i) {
    return {triples[3 * i], triples[3 * i + 1], triples[3 * i + 2]};
  }
  render::Evaluator& evaluator_;
  chart::ByHalfVector<float, chart::PowerNormals<float>> strategy_{{kNu, kNv}};
};

struct Timed {
  Image picture;
  double seconds;
};

Timed picture(render::Surface& surface, int size, int samples, render::Technique technique) {
  const auto shape = render::make_shape(render::ShapeKind::cylinder);
  const render::Camera camera({.elevation = 25, .zoom = 1.6}, shape->radius(), size, size);
  const auto light = render::dome_light(render::sky_map(), "sky");
  const auto start = std::chrono::steady_clock::now();
  auto made = render::render({*shape, camera, **light, std::nullopt},
                             {size, size, samples, 1, technique, 1}, surface, [](double) {});
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (!made) {
    std::fprintf(stderr, "closeup: %s\n", made.error().message.c_str());
    std::exit(1);
  }
  return {std::move(made).value(), taken.count()};
}

double relative_error(const Image& image, const Image& truth) {
  double squares = 0, sum = 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    const Eigen::Array3d difference = (image.pixels[i] - truth.pixels[i]).cast<double>();
    squares += difference.square().mean();
    sum += static_cast<double>(truth.pixels[i].mean());
  }
  const auto count = static_cast<double>(truth.pixels.size());
  return std::sqrt(squares / count) / (sum / count);
}

void print_curve(const char* name, render::Surface& surface, int size, const Image& truth) {
  for (const int samples : {1, 4, 9, 16, 26, 49, 100, 256}) {
    Timed best = picture(surface, size, samples, render::Technique::surface);
    for (int again = 0; again < 2; ++again)
      best.seconds = std::min(best.seconds,
                              picture(surface, size, samples, render::Technique::surface).seconds);
    std::printf("%s,%d,%.4f,%.6f\n", name, samples, best.seconds,
                relative_error(best.picture, truth));
    std::fflush(stdout);
  }
}

int run(int size) {
  auto connection = cli::Connection::open({});
  auto material = client::Material::model(
      "ashikhmin_shirley",
      {{"rd", {0.0}}, {"rs", {0.9}}, {"nu", {double{kNu}}}, {"nv", {double{kNv}}}});
  auto evaluator = render::Evaluator::create(connection->client, material);
  Paper paper(*evaluator);
  const Image truth = picture(*evaluator, size, 4096, render::Technique::both).picture;
  std::printf("strategy,samples,seconds,error\n");
  print_curve("gonio", *evaluator, size, truth);
  print_curve("paper", paper, size, truth);
  return 0;
}

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) { return gonio::bench::run(argc > 1 ? std::atoi(argv[1]) : 96); }
