#include "client/picture/lobe/colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gonio::lobe {

Colour false_colour(double position) {
  static constexpr std::array<Colour, 10> kColours = {{{0.0015, 0.0005, 0.0139},
                                                       {0.1064, 0.0474, 0.2591},
                                                       {0.2954, 0.0430, 0.4258},
                                                       {0.4718, 0.1110, 0.4281},
                                                       {0.6461, 0.1713, 0.3819},
                                                       {0.8015, 0.2601, 0.2886},
                                                       {0.9276, 0.4095, 0.1615},
                                                       {0.9830, 0.5989, 0.0237},
                                                       {0.9625, 0.8143, 0.1988},
                                                       {0.9884, 0.9984, 0.6449}}};
  const double place = std::clamp(position, 0.0, 1.0) * (kColours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kColours.size() - 2);
  const double part = place - static_cast<double>(below);
  const Colour &a = kColours[below], &b = kColours[below + 1];
  return {std::lerp(a.red, b.red, part), std::lerp(a.green, b.green, part),
          std::lerp(a.blue, b.blue, part)};
}

}  // namespace gonio::lobe
