#include "client/picture/lobe/lobe.h"

#include <algorithm>
#include <cmath>

#include "client/picture/render/geometry.h"

namespace gonio::lobe {
namespace {

using image::Rgb;
using render::radians;
using render::Vec3;

constexpr double kStep = 0.1;        // degrees
constexpr double kHorizon = 89.999;  // beyond it, values are 0

// The pairs of one wi, evaluated a bounded number at a time.
class Batch {
 public:
  Batch(const Incidence& incidence, render::Evaluator& evaluator)
      : incidence_(incidence),
        evaluator_(evaluator),
        wi_(render::direction_of(radians(incidence.theta_i), radians(incidence.phi_i))) {}

  // `along` away from the light, `across` to the left of that, `up`: a local direction.
  Outcome add(double along, double across, double up) {
    const double phi = radians(incidence_.phi_i);
    const double c = -std::cos(phi), s = -std::sin(phi);
    for (const double x : {c * along - s * across, s * along + c * across, up}) {
      wo_.push_back(static_cast<float>(x));
    }
    return wo_.size() < 3 * kMost ? Outcome(Ok{}) : evaluate();
  }

  Result<std::vector<Rgb>> finish() {
    if (auto done = evaluate(); !done) return done.error();
    return std::move(values_);
  }

 private:
  static constexpr std::size_t kMost = 131072;

  Outcome evaluate() {
    const std::size_t count = wo_.size() / 3, before = values_.size();
    std::vector<float> wi;
    for (std::size_t i = 0; i < count; ++i) {
      for (const double x : wi_) wi.push_back(static_cast<float>(x));
    }
    values_.resize(before + count);
    const auto values = std::span(values_).subspan(before);
    if (auto done = evaluator_.evaluate(wi, wo_, values, {}); !done) return done;
    for (std::size_t i = 0; i < count && incidence_.cosine; ++i) values[i] *= wo_[3 * i + 2];
    wo_.clear();
    return Ok{};
  }

  const Incidence& incidence_;
  render::Evaluator& evaluator_;
  Vec3 wi_;
  std::vector<float> wo_;
  std::vector<Rgb> values_;
};

}  // namespace

std::vector<double> angles_around(double mirror) {
  std::vector<double> angles;
  const int steps = static_cast<int>(std::lround(90 / kStep));
  for (int i = -steps; i <= steps; ++i) angles.push_back(i * kStep);
  for (double offset = 1e-4; offset < 2; offset *= 1.1) {
    angles.insert(angles.end(), {mirror - offset, mirror + offset});
  }
  angles.push_back(mirror);
  for (double& angle : angles) angle = std::clamp(angle, -kHorizon, kHorizon);
  std::sort(angles.begin(), angles.end());
  return angles;
}

Result<Curve> curve_of(const Incidence& incidence, render::Evaluator& evaluator) {
  Batch batch(incidence, evaluator);
  Curve curve;
  curve.theta_o = angles_around(incidence.theta_i);
  for (const double theta : curve.theta_o) {
    auto added = batch.add(std::sin(radians(theta)), 0, std::cos(radians(theta)));
    if (!added) return added.error();
  }
  auto values = batch.finish();
  if (!values) return values.error();
  curve.values = std::move(values).value();
  return curve;
}

Result<std::vector<Rgb>> hemisphere_of(const Incidence& incidence, int side,
                                       render::Evaluator& evaluator) {
  Batch batch(incidence, evaluator);
  std::vector<std::size_t> pixels;  // of each direction
  const auto fine = static_cast<std::size_t>(side) * 2;
  for (std::size_t row = 0; row < fine; ++row) {
    for (std::size_t column = 0; column < fine; ++column) {
      const double x = (static_cast<double>(column) + 0.5) / side - 1;
      const double y = 1 - (static_cast<double>(row) + 0.5) / side;
      const double squared = x * x + y * y;
      if (squared >= 1) continue;
      pixels.push_back(row / 2 * static_cast<std::size_t>(side) + column / 2);
      if (auto added = batch.add(x, y, std::sqrt(1 - squared)); !added) return added.error();
    }
  }
  auto values = batch.finish();
  if (!values) return values.error();
  // A pixel on the rim is the mean of those of its four directions that are above the horizon.
  std::vector<Rgb> means(static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                         Rgb::Zero());
  std::vector<float> counts(means.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    means[pixels[i]] += (*values)[i];
    counts[pixels[i]] += 1;
  }
  for (std::size_t i = 0; i < means.size(); ++i) means[i] /= std::max(counts[i], 1.0F);
  return means;
}

}  // namespace gonio::lobe
