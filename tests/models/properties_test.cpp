// What every reflectance must be, whatever its formula: reciprocal, and no source of energy. Loops
// over the registry with parameters drawn from each model's own table.
#include <gtest/gtest.h>

#include <iostream>
#include <numbers>

#include "models/draws.h"
#include "models/run.h"

namespace gonio::testing {
namespace {

std::vector<std::string> analytic_models() {
  std::vector<std::string> names;
  for (const ModelDescription& model : models()) {
    if (model.role != Role::measured) names.emplace_back(model.name);
  }
  return names;
}

class Properties : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static const ModelDescription& model() { return **find_model(GetParam()); }
};

template <class In>
std::vector<DirectionPair<In>> exchanged(std::vector<DirectionPair<In>> pairs) {
  for (auto& pair : pairs) std::swap(pair.wi, pair.wo);
  return pairs;
}

template <class Out>
void expect_reciprocal(const Draw& draw, const std::vector<DirectionPair<float>>& pairs) {
  const Material material = material_of(draw.spec);
  const ErrorBound bound =
      material.error_bound(sizeof(Out) == 4 ? Precision::fast : Precision::reference);
  for (const Isa isa : supported_isas()) {
    const std::vector<Out> there = library_values<Out>(material, pairs, isa);
    const std::vector<Out> back = library_values<Out>(material, exchanged(pairs), isa);
    for (std::size_t i = 0; i < there.size(); ++i) {
      const double a = static_cast<double>(there[i]), b = static_cast<double>(back[i]);
      ASSERT_TRUE(std::isfinite(a) && std::isfinite(b));
      const double larger = std::max(a, b);
      const auto& pair = pairs[i / (there.size() / pairs.size())];
      const double cosine = std::min(pair.wi[2], pair.wo[2]);
      if (larger <= bound.above || cosine < 1.001 * bound.cosine) continue;
      ASSERT_LE((larger - std::min(a, b)) / larger, 2 * bound.relative)
          << draw.name << ", " << name_of(isa) << ", pair " << i / 3 << ": " << a << " and " << b;
    }
  }
}

TEST_P(Properties, IsReciprocal) {
  auto pairs = hard_pairs<float>(11);
  std::shuffle(pairs.begin(), pairs.end(), std::mt19937(1));
  pairs.resize(4000);
  for (const Draw& draw : draws_of(model())) {
    expect_reciprocal<float>(draw, pairs);
    expect_reciprocal<double>(draw, pairs);
  }
}

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
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// The albedo of each channel for light from `fixed`, then for all light that leaves into it.
std::vector<double> albedos(const MaterialSpec& spec, const std::array<double, 3>& fixed,
                            const Quadrature& quadrature) {
  const Material material = material_of(spec);
  const auto channels = static_cast<std::size_t>(material.channels());
  std::vector<DirectionPair<double>> pairs;
  for (const auto& w : quadrature.directions) pairs.push_back({fixed, w, PairKind::special});
  std::vector<double> sums(2 * channels);
  for (std::size_t side = 0; side < 2; ++side) {
    const auto values = library_values<double>(material, pairs, best_isa());
    for (std::size_t i = 0; i < values.size(); ++i) {
      sums[side * channels + i % channels] += quadrature.weights[i / channels] * values[i];
    }
    pairs = exchanged(std::move(pairs));
  }
  return sums;
}

constexpr std::array<double, 6> kElevations{90, 60, 30, 10, 2, 0.1};
constexpr double kQuadratureError = 2e-3;

TEST(Quadrature, IntegratesAConstantAtEveryElevation) {
  for (const double elevation : kElevations) {
    double sum = 0;
    for (const double w : quadrature_about(at_elevation(elevation)).weights) sum += w;
    EXPECT_NEAR(sum, std::numbers::pi, kQuadratureError) << elevation;
  }
}

TEST_P(Properties, GainsNoEnergy) {
  double highest = 0;
  for (const double elevation : kElevations) {
    const Quadrature quadrature = quadrature_about(at_elevation(elevation));
    for (const Draw& draw : draws_of(model())) {
      for (const double a : albedos(draw.spec, at_elevation(elevation), quadrature)) {
        EXPECT_LE(a, model().albedo_limit * (1 + kQuadratureError))
            << draw.name << ", elevation " << elevation;
        highest = std::max(highest, a);
      }
    }
  }
  EXPECT_GT(highest, 0);
  RecordProperty("highest albedo", std::to_string(highest));
}

// What white surfaces lose, and that those said to gain energy do.
TEST_P(Properties, SaysWhatItLosesOrGains) {
  const double limit = model().albedo_limit;
  double lowest = limit, highest = 0;
  std::string where;
  for (const double elevation : kElevations) {
    const Quadrature quadrature = quadrature_about(at_elevation(elevation));
    for (const Draw& draw : white_draws_of(model())) {
      for (const double a : albedos(draw.spec, at_elevation(elevation), quadrature)) {
        EXPECT_LE(a, limit * (1 + kQuadratureError)) << draw.name << ", elevation " << elevation;
        highest = std::max(highest, a);
        if (a < lowest) lowest = a, where = draw.name + " at " + std::to_string(elevation);
      }
    }
  }
  if (limit > 1) {
    EXPECT_GT(highest, 1 + (limit - 1) / 2) << "less than it says";
  }
  RecordProperty("lowest white albedo", std::to_string(lowest));
  RecordProperty("highest white albedo", std::to_string(highest));
  std::cout << GetParam() << ": white albedo from " << lowest << " (" << where << " degrees) to "
            << highest << "\n";
}

INSTANTIATE_TEST_SUITE_P(Models, Properties, ::testing::ValuesIn(analytic_models()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace gonio::testing
