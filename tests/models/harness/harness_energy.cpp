// Energy: albedos by a quadrature that resolves every lobe.
#include <cmath>
#include <numbers>

#include "models/harness/findings.h"
#include "models/harness/harness.h"
#include "models/oracle/run.h"
#include "numeric/direction.h"

namespace gonio::testing {
namespace {

using Pairs = std::vector<DirectionPair<double>>;

// Directions about a fixed one with weights cos(theta) d(omega), so that a sum over f is an albedo.
// They are the mirror images of `fixed` in half-vectors whose slopes run over all orders of
// magnitude along both tangents: no lobe is too sharp or too anisotropic to be resolved.
struct Quadrature {
  std::vector<std::array<double, 3>> directions;
  std::vector<double> weights;
};

Quadrature quadrature_about(const std::array<double, 3>& fixed) {
  constexpr int kSteps = 160;
  const double low = std::log(1e-7), step = (std::log(1e5) - low) / kSteps;
  Quadrature result;
  for (int i = 0; i < 4 * kSteps * kSteps; ++i) {
    const int quadrant = i / (kSteps * kSteps), column = i / kSteps % kSteps, row = i % kSteps;
    const double x = std::exp(low + (column + 0.5) * step) * (quadrant % 2 == 0 ? 1 : -1);
    const double y = std::exp(low + (row + 0.5) * step) * (quadrant / 2 == 0 ? 1 : -1);
    const double length = std::sqrt(1 + x * x + y * y);
    const std::array<double, 3> h{x / length, y / length, 1 / length};
    const double cos_d = h[0] * fixed[0] + h[1] * fixed[1] + h[2] * fixed[2];
    const double z = 2 * cos_d * h[2] - fixed[2];
    if (cos_d <= 0 || z <= 0) continue;
    // d(omega) = 4 (h.fixed) d(omega_h), d(omega_h) = dx dy / length^3.
    const double measure = std::abs(x * y) * step * step / (length * length * length);
    result.directions.push_back({2 * cos_d * h[0] - fixed[0], 2 * cos_d * h[1] - fixed[1], z});
    result.weights.push_back(4 * cos_d * measure * z);
  }
  return result;
}

std::array<double, 3> at_elevation(double degrees) {
  const double theta = (90 - degrees) * std::numbers::pi / 180, phi = 0.4;
  return spherical(theta, phi);
}

// The pairs of light from `fixed` with all directions, and the other way about.
std::pair<Pairs, Pairs> both_ways(const std::array<double, 3>& fixed,
                                  const Quadrature& quadrature) {
  std::pair<Pairs, Pairs> ways;
  for (const auto& w : quadrature.directions) {
    ways.first.push_back({fixed, w, PairKind::special});
    ways.second.push_back({w, fixed, PairKind::special});
  }
  return ways;
}

// The albedo of each channel.
std::vector<double> albedos(const Subject& subject, const MaterialSpec& spec, const Pairs& pairs,
                            const Quadrature& quadrature) {
  const auto values = subject.reference(spec, pairs, best_isa());
  const std::size_t channels = values.size() / pairs.size();
  std::vector<double> sums(channels);
  for (std::size_t i = 0; i < values.size(); ++i) {
    sums[i % channels] += quadrature.weights[i / channels] * values[i];
  }
  return sums;
}

constexpr std::array<double, 6> kElevations{90, 60, 30, 10, 2, 0.1};
constexpr double kQuadratureError = 2e-3;

template <class Each>
void each_albedo(const Subject& subject, const std::vector<Draw>& draws, const Each& each) {
  for (const double elevation : kElevations) {
    const auto fixed = at_elevation(elevation);
    const Quadrature quadrature = quadrature_about(fixed);
    const auto [there, back] = both_ways(fixed, quadrature);
    for (const Draw& draw : draws) {
      for (const Pairs* pairs : {&there, &back}) {
        for (const double a : albedos(subject, draw.spec, *pairs, quadrature))
          each(draw.name + ", elevation " + std::to_string(elevation), a);
      }
    }
  }
}

}  // namespace

Findings check_energy(const Subject& subject) {
  Notes notes;
  const double limit = subject.description.albedo_limit * (1 + kQuadratureError);
  each_albedo(subject, draws_of(subject.description), [&](const std::string& where, double a) {
    if (!(a <= limit)) notes.add(where + ": albedo " + std::to_string(a));
  });
  return notes.findings();
}

AlbedoRange white_albedos(const Subject& subject) {
  AlbedoRange range;
  each_albedo(subject, white_draws_of(subject.description),
              [&](const std::string& where, double a) {
                range.highest = std::max(range.highest, a);
                if (a < range.lowest) range.lowest = a, range.lowest_at = where;
              });
  return range;
}

double quadrature_error() {
  double worst = 0;
  for (const double elevation : kElevations) {
    double sum = 0;
    for (const double w : quadrature_about(at_elevation(elevation)).weights) sum += w;
    worst = std::max(worst, std::abs(sum / std::numbers::pi - 1));
  }
  return worst / kQuadratureError;
}

}  // namespace gonio::testing
