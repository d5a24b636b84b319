#include "client/picture/image/srgb.h"

#include <algorithm>
#include <cmath>

namespace gonio::image {

float srgb_encoded(float linear) {
  if (!(linear > 0)) return 0;
  const float x = std::min(linear, 1.0F);
  return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
}

std::vector<std::uint8_t> srgb_bytes(const Image& image, double exposure) {
  const auto scale = static_cast<float>(std::exp2(exposure));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels) {
    for (const float value : pixel) {
      bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * srgb_encoded(scale * value))));
    }
  }
  return bytes;
}

}  // namespace gonio::image
