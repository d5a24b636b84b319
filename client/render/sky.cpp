#include "client/render/sky.h"

#include <cmath>
#include <numbers>

namespace gonio::render {
namespace {

constexpr int kHeight = 512;  // even: the horizon is between two rows

}  // namespace

image::Image sky_map() {
  const image::Rgb horizon(1.25F, 1.2F, 1.15F), zenith(0.16F, 0.32F, 0.75F),
      ground(0.16F, 0.145F, 0.13F);
  image::Image map(2 * kHeight, kHeight);
  for (int row = 0; row < kHeight; ++row) {
    const double sine = std::cos(std::numbers::pi * (row + 0.5) / kHeight);
    const image::Rgb radiance =
        sine > 0 ? image::Rgb(horizon + (zenith - horizon) * static_cast<float>(std::sqrt(sine)))
                 : ground;
    for (int column = 0; column < map.width; ++column) map.at(column, row) = radiance;
  }
  return map;
}

}  // namespace gonio::render
