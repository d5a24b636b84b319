#include "select/distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::select {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
// Measured directions are float32 and often lie on the edge of a range: it belongs to it.
constexpr double kEdge = 1e-6, kAzimuthEdge = 1e-5;

bool within(double x, double lower, double upper, double edge) {
  return x >= lower - edge && x <= upper + edge;
}

// The angle between the azimuths, 0 to pi.
double azimuth_between(const Direction& a, const Direction& b) {
  const double along = a[0] * b[0] + a[1] * b[1], across = a[0] * b[1] - a[1] * b[0];
  return std::abs(std::atan2(across, along));
}

Direction direction(double cosine, double azimuth) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

}  // namespace

Distribution::Distribution(const Scene& scene) {
  double all = 0, sum = 0;
  for (const Bin& bin : scene.bins) all += bin.weight;
  for (const Bin& bin : scene.bins) {
    Box box{std::cos(bin.theta_i.upper),
            std::cos(bin.theta_i.lower),
            std::cos(bin.theta_o.upper),
            std::cos(bin.theta_o.lower),
            bin.phi.lower,
            bin.phi.upper,
            0,
            0};
    const double share = bin.weight / all;
    box.incident = share / (kTurn * (box.ci_upper - box.ci_lower));
    // phi lies to both sides.
    box.density =
        box.incident / ((box.co_upper - box.co_lower) * 2 * (box.phi_upper - box.phi_lower));
    boxes_.push_back(box);
    sum += share;
    up_to_.push_back(sum);
  }
}

double Distribution::density(const Direction& wi, const Direction& wo) const {
  const double phi = azimuth_between(wi, wo);
  double sum = 0;
  for (const Box& box : boxes_) {
    const bool inside = within(wi[2], box.ci_lower, box.ci_upper, kEdge) &&
                        within(wo[2], box.co_lower, box.co_upper, kEdge) &&
                        within(phi, box.phi_lower, box.phi_upper, kAzimuthEdge);
    if (inside) sum += box.density;
  }
  return sum;
}

double Distribution::incident_density(const Direction& wi) const {
  double sum = 0;
  for (const Box& box : boxes_) {
    if (within(wi[2], box.ci_lower, box.ci_upper, kEdge)) sum += box.incident;
  }
  return sum;
}

Pair Distribution::draw(std::mt19937_64& random) const {
  std::uniform_real_distribution<double> uniform;
  const auto found = std::upper_bound(up_to_.begin(), up_to_.end() - 1, uniform(random));
  const Box& box = boxes_[static_cast<std::size_t>(found - up_to_.begin())];
  // Never the lower cosine itself, which may be 0: the horizon.
  const auto between = [&](double lower, double upper) {
    return upper - (upper - lower) * uniform(random);
  };
  const double ci = between(box.ci_lower, box.ci_upper), co = between(box.co_lower, box.co_upper);
  const double turn = kTurn * uniform(random), phi = between(box.phi_lower, box.phi_upper);
  const double side = uniform(random) < 0.5 ? -1 : 1;
  return {direction(ci, turn), direction(co, turn + side * phi)};
}

}  // namespace gonio::select
