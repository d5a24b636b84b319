#include "client/picture/render/sky.h"

#include <cmath>
#include <numbers>

#include "client/picture/render/geometry.h"

namespace gonio::render {
namespace {

using image::Rgb;

constexpr int kHeight = 256;  // even: the horizon is between two rows
constexpr double kSunAzimuth = -125, kSunTheta = 45, kGlow = 30;

Rgb radiance(const Vec3& direction) {
  static const Vec3 sun = direction_of(radians(kSunTheta), radians(kSunAzimuth));
  const Rgb horizon(0.95F, 0.95F, 0.93F), zenith(0.12F, 0.24F, 0.55F), glow(7.0F, 6.2F, 5.0F),
      haze(0.33F, 0.31F, 0.29F), ground(0.10F, 0.09F, 0.08F);
  const auto height = static_cast<float>(std::sqrt(std::abs(direction.z())));
  if (direction.z() < 0) return haze + (ground - haze) * height;
  const auto veil = static_cast<float>(std::exp(kGlow * (direction.dot(sun) - 1)));
  return horizon + (zenith - horizon) * height + glow * veil;
}

}  // namespace

image::Image sky_map() {
  image::Image map(2 * kHeight, kHeight);
  for (int row = 0; row < map.height; ++row) {
    const double theta = std::numbers::pi * (row + 0.5) / map.height;
    for (int column = 0; column < map.width; ++column) {
      // As dome_light() lays its columns out.
      const double azimuth = 2 * std::numbers::pi * ((column + 0.5) / map.width - 0.5);
      map.at(column, row) = radiance(direction_of(theta, std::numbers::pi / 2 - azimuth));
    }
  }
  return map;
}

}  // namespace gonio::render
