#include "fit/report/albedo.h"

#include <cmath>
#include <numbers>

#include "gonio/engine/evaluate.h"
#include "gonio/engine/isa.h"

namespace gonio::fit {
namespace {

constexpr std::size_t kRings = 192, kSpokes = 48;

// Directions in rings about the mirror direction, closest where a sharp lobe is: the angle from it
// is pi t^3.
struct Rings {
  explicit Rings(double theta) {
    const double s = std::sin(theta), c = std::cos(theta);
    for (std::size_t i = 0; i < kRings; ++i) {
      const double t = (static_cast<double>(i) + 0.5) / kRings,
                   angle = std::numbers::pi * t * t * t;
      const double step = 3 * std::numbers::pi * t * t / kRings;
      for (std::size_t j = 0; j < kSpokes; ++j) {
        const double turn = 2 * std::numbers::pi * (static_cast<double>(j) + 0.5) / kSpokes;
        const double x = std::sin(angle) * std::cos(turn), z = std::cos(angle);
        const double up = c * z + s * x;
        if (up <= 0) continue;
        const double out[3] = {c * x - s * z, std::sin(angle) * std::sin(turn), up};
        const double in[3] = {s, 0, c};
        wi.insert(wi.end(), in, in + 3);
        wo.insert(wo.end(), out, out + 3);
        measure.push_back(up * std::sin(angle) * step * 2 * std::numbers::pi / kSpokes);
      }
    }
  }
  std::vector<double> wi, wo, measure;  // measure: cos(theta_o) d(wo)
};

}  // namespace

std::vector<double> directional_albedo(const Material& material, double theta) {
  const Rings rings(theta);
  const auto channels = static_cast<std::size_t>(material.channels());
  const std::size_t n = rings.measure.size();
  std::vector<double> values(n * channels), albedo(channels, 0);
  evaluate(material,
           Batch<double, double>{Directions<double>::interleaved(rings.wi.data()),
                                 Directions<double>::interleaved(rings.wo.data()), n,
                                 Values<double>::planar(values.data(), n), nullptr},
           best_isa());
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < n; ++i) albedo[c] += values[c * n + i] * rings.measure[i];
  }
  return albedo;
}

}  // namespace gonio::fit
