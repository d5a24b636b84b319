// Draws by a bilinear density, held against its integral.
#include "measured/bilinear_density.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gonio::testing {
namespace {

// The part of the density's integral left of and below a place is what was asked for.
TEST(BilinearDensity, DrawsByItsOwnIntegral) {
  const std::vector<float> nodes{0, 1, 4, 2, 0, 3, 5, 0, 0};
  const BilinearDensity density(nodes, 3, 3);
  const auto value = [&](double u, double v) {
    const auto at = [&](double x, double y) {
      return static_cast<double>(nodes[static_cast<std::size_t>(3 * y + x)]);
    };
    const double x = std::min(std::floor(2 * u), 1.0), y = std::min(std::floor(2 * v), 1.0);
    const double a = 2 * u - x, b = 2 * v - y;
    return (1 - b) * ((1 - a) * at(x, y) + a * at(x + 1, y)) +
           b * ((1 - a) * at(x, y + 1) + a * at(x + 1, y + 1));
  };
  constexpr int kSteps = 400;
  double whole = 0;
  for (int i = 0; i < kSteps * kSteps; ++i)
    whole += value((i % kSteps + 0.5) / kSteps, (i / kSteps + 0.5) / kSteps) / kSteps / kSteps;
  for (const double t : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const auto place = density.at(s, t);
      EXPECT_NEAR(place.density, value(place.u, place.v) / whole, 1e-4);
      double rows = 0, left = 0, row = 0;
      for (int i = 0; i < kSteps * kSteps; ++i)
        rows += place.v * value((i % kSteps + 0.5) / kSteps, place.v * (i / kSteps + 0.5) / kSteps);
      for (int i = 0; i < kSteps; ++i) {
        left += place.u * value(place.u * (i + 0.5) / kSteps, place.v);
        row += value((i + 0.5) / kSteps, place.v);
      }
      EXPECT_NEAR(rows / kSteps / kSteps / whole, t, 1e-4);
      EXPECT_NEAR(left / row, s, 1e-3);
    }
  }
}

TEST(BilinearDensity, OfNothingIsNothing) {
  const std::vector<float> nodes(4, 0);
  EXPECT_EQ(BilinearDensity(nodes, 2, 2).at(0.5, 0.5).density, 0);
}

}  // namespace
}  // namespace gonio::testing
