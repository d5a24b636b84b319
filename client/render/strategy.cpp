#include "client/render/strategy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::render {
namespace {

using std::numbers::pi;

class LightDirections : public Strategy {
 public:
  explicit LightDirections(const Light& light) : light_(light) {}

  [[nodiscard]] Outcome propose(std::span<const Point> points, std::span<const Xi> xi,
                                std::span<Vec3f> wi) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      wi[i] = points[i].frame.to_local(light_.sample(xi[i]));
    }
    return Ok{};
  }

  [[nodiscard]] Outcome densities(std::span<const Point> points, std::span<const Vec3f> wi,
                                  std::span<double> density) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      density[i] = light_.density(points[i].frame.to_world(wi[i]));
    }
    return Ok{};
  }

 private:
  const Light& light_;
};

class CosineHemisphere : public Strategy {
 public:
  [[nodiscard]] Outcome propose(std::span<const Point> /*points*/, std::span<const Xi> xi,
                                std::span<Vec3f> wi) const override {
    for (std::size_t i = 0; i < xi.size(); ++i) {
      const double r = std::sqrt(xi[i][0]), phi = 2 * pi * xi[i][1];
      wi[i] = Vec3(r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - xi[i][0])).cast<float>();
    }
    return Ok{};
  }

  [[nodiscard]] Outcome densities(std::span<const Point> /*points*/, std::span<const Vec3f> wi,
                                  std::span<double> density) const override {
    std::transform(wi.begin(), wi.end(), density.begin(),
                   [](const Vec3f& w) { return std::max(0.0F, w.z()) / pi; });
    return Ok{};
  }
};

}  // namespace

std::vector<std::unique_ptr<const Strategy>> strategies_for(const Light& light) {
  std::vector<std::unique_ptr<const Strategy>> strategies;
  strategies.push_back(std::make_unique<LightDirections>(light));
  if (!light.single_direction()) strategies.push_back(std::make_unique<CosineHemisphere>());
  return strategies;
}

}  // namespace gonio::render
