#include "select/error/distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace gonio::select {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
// Measured directions are float32 and often lie on the edge of a range, which belongs to the range.
constexpr double kEdge = 1e-6, kAzimuthEdge = 1e-5;

// The angle between the azimuths, 0 to pi; none where one of the directions is the normal.
std::optional<double> azimuth_between(const Direction& a, const Direction& b) {
  const double along = a[0] * b[0] + a[1] * b[1], across = a[0] * b[1] - a[1] * b[0];
  if (along == 0 && across == 0) return std::nullopt;
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
    Box box{{std::cos(bin.theta_i.upper), std::cos(bin.theta_i.lower)},
            {std::cos(bin.theta_o.upper), std::cos(bin.theta_o.lower)},
            {bin.phi.lower, bin.phi.upper},
            0,
            0};
    const double share = bin.weight / all;
    box.incident = share / (kTurn * box.ci.length());
    // phi stands for both signs.
    box.density = box.incident / (box.co.length() * 2 * box.phi.length());
    boxes_.push_back(box);
    sum += share;
    up_to_.push_back(sum);
  }
  inside_ = boxes_;
  widen(&Box::ci, kEdge);
  widen(&Box::co, kEdge);
  widen(&Box::phi, kAzimuthEdge);
}

void Distribution::widen(Interval Box::*interval, double edge) {
  double lower = 1e300, upper = -1e300;
  for (const Box& box : boxes_) {
    lower = std::min(lower, (box.*interval).lower);
    upper = std::max(upper, (box.*interval).upper);
  }
  for (Box& box : inside_) {
    Interval& own = box.*interval;
    if (own.lower == lower) own.lower -= edge;
    if (own.upper == upper) own.upper += edge;
  }
}

double Distribution::density(const Direction& wi, const Direction& wo) const {
  const auto phi = azimuth_between(wi, wo);
  double sum = 0;
  for (std::size_t i = 0; i < inside_.size(); ++i) {
    const Box& box = inside_[i];
    if (!box.ci.holds(wi[2]) || !box.co.holds(wo[2])) continue;
    if (!phi) {
      sum += box.density * boxes_[i].phi.length() / std::numbers::pi;
    } else if (box.phi.holds(*phi)) {
      sum += box.density;
    }
  }
  return sum;
}

double Distribution::incident_density(const Direction& wi) const {
  double sum = 0;
  for (const Box& box : inside_) {
    if (box.ci.holds(wi[2])) sum += box.incident;
  }
  return sum;
}

Pair Distribution::draw(std::mt19937_64& random) const {
  std::uniform_real_distribution<double> uniform;
  const auto found = std::upper_bound(up_to_.begin(), up_to_.end() - 1, uniform(random));
  const Box& box = boxes_[static_cast<std::size_t>(found - up_to_.begin())];
  // Never the lower cosine itself, which may be 0: the horizon.
  const auto between = [&](const Interval& of) { return of.upper - of.length() * uniform(random); };
  const double ci = between(box.ci), co = between(box.co);
  const double turn = kTurn * uniform(random), phi = between(box.phi);
  const double side = uniform(random) < 0.5 ? -1 : 1;
  return {direction(ci, turn), direction(co, turn + side * phi)};
}

}  // namespace gonio::select
