// The measure that a measurement stands for.
#include "measured/solid_angle.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <span>

#include "effort.h"

namespace gonio::testing {
namespace {

using ::testing::IsEmpty;

constexpr double kPi = std::numbers::pi;

void push(std::vector<double>& to, double theta, double phi) {
  const double s = std::sin(theta);
  to.insert(to.end(), {s * std::cos(phi), s * std::sin(phi), std::cos(theta)});
}

// A polar grid: `rings` of theta, `turns` of phi, at the cells' centres.
std::vector<double> polar(int rings, int turns) {
  std::vector<double> all;
  for (int r = 0; r < rings; ++r) {
    for (int t = 0; t < turns; ++t)
      push(all, (r + 0.5) * kPi / 2 / rings, 2 * kPi * (t + 0.5) / turns);
  }
  return all;
}

TEST(SolidAngles, OfAPolarGridAreThoseOfItsCells) {
  const auto angles = solid_angles(polar(9, 36));
  EXPECT_NEAR(std::accumulate(angles.begin(), angles.end(), 0.0), 2 * kPi, 0.01);
  for (int r = 1; r < 8; ++r) {  // the nearest to the pole are triangles
    const double cell = 2 * kPi / 36 * (std::cos(r * kPi / 18) - std::cos((r + 1) * kPi / 18));
    const double found =
        std::accumulate(angles.begin() + 36 * r, angles.begin() + 36 * (r + 1), 0.0) / 36;
    EXPECT_NEAR(found, cell, 0.05 * cell) << r;
  }
}

TEST(SolidAngles, AgreeWithChanceForScatteredDirections) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform;
  std::vector<double> all;
  for (int i = 0; i < 200; ++i) push(all, std::acos(uniform(random)), 2 * kPi * uniform(random));
  const auto angles = solid_angles(all);
  std::vector<double> hits(200, 0);
  constexpr int kShots = 200'000;
  for (int shot = 0; shot < kShots; ++shot) {
    std::vector<double> w;
    push(w, std::acos(uniform(random)), 2 * kPi * uniform(random));
    std::size_t nearest = 0;
    double best = -2;
    for (std::size_t i = 0; i < 200; ++i) {
      const double cosine = w[0] * all[3 * i] + w[1] * all[3 * i + 1] + w[2] * all[3 * i + 2];
      if (cosine > best) best = cosine, nearest = i;
    }
    if (best > std::cos(kPi / 12)) hits[nearest] += 2 * kPi / kShots;
  }
  for (std::size_t i = 0; i < 200; ++i)
    EXPECT_NEAR(angles[i], hits[i], 1e-3 + 4 * std::sqrt(hits[i] * 2 * kPi / kShots)) << i;
}

TEST(SolidAngles, OfWhatIsNoDirectionAreNothing) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> all{0, 0, 1, kNan, 0, 1, 0, 0, -1, 1, 0, 0};
  const auto angles = solid_angles(all);
  EXPECT_NEAR(angles[0], 2 * kPi * (1 - std::cos(kPi / 12)), 0.01);
  EXPECT_EQ(angles[1], 0);
  EXPECT_EQ(angles[2], 0);
  EXPECT_EQ(angles[3], 0);
  EXPECT_THAT(solid_angles({}), IsEmpty());
}

TEST(PairMeasures, OfAWholeGoniometerAreAllPairs) {
  std::vector<double> wi, wo;
  const auto outgoing = polar(9, 36);
  for (const double theta : {10, 30, 50, 70}) {
    for (std::size_t i = 0; i < outgoing.size(); i += 3) {
      push(wi, theta * kPi / 180, 1);
      wo.insert(wo.end(), {outgoing[i], outgoing[i + 1], outgoing[i + 2]});
    }
  }
  const auto measures = pair_measures(wi, wo);
  ASSERT_EQ(measures.size(), wi.size() / 3);
  EXPECT_NEAR(std::accumulate(measures.begin(), measures.end(), 0.0), 4 * kPi * kPi, 0.1);
  const std::size_t per_wi = outgoing.size() / 3;
  EXPECT_NEAR(
      measures[per_wi + 100] / measures[100],
      (std::cos(20 * kPi / 180) - std::cos(40 * kPi / 180)) / (1 - std::cos(20 * kPi / 180)), 1e-9);
}

// A grid of half a degree for each wi would take minutes.
TEST(PairMeasures, OfManyIncidencesAreFoundOnACoarserGrid) {
  constexpr std::size_t kIncidences = 10'000 / kSlower;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform;
  std::vector<double> wi, wo;
  for (std::size_t i = 0; i < kIncidences; ++i) {
    const double theta = std::acos(uniform(random)), phi = 2 * kPi * uniform(random);
    for (int turn = 0; turn < 8; ++turn) {
      push(wi, theta, phi);
      push(wo, 0.8, 2 * kPi * turn / 8);
    }
  }
  const auto begin = WorkClock::now();
  const auto measures = pair_measures(wi, wo);
  EXPECT_LT(WorkClock::now() - begin, std::chrono::seconds(20));
  ASSERT_EQ(measures.size(), wi.size() / 3);
  const auto angles = solid_angles(std::span(wo).first(24));
  const double expected = 2 * kPi * std::accumulate(angles.begin(), angles.end(), 0.0);
  // A little more: so many wi are closer than the grid, and each stands for something.
  EXPECT_NEAR(std::accumulate(measures.begin(), measures.end(), 0.0), expected, 0.08 * expected);
  for (std::size_t turn = 1; turn < 8; ++turn)
    EXPECT_NEAR(measures[turn] / measures[0], 1, 0.1) << turn;
}

TEST(PairMeasures, OfOtherDataAreNotKnown) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform;
  std::vector<double> wi, wo;
  for (int i = 0; i < 100; ++i) {
    push(wi, uniform(random), uniform(random));
    push(wo, uniform(random), uniform(random));
  }
  EXPECT_THAT(pair_measures(wi, wo), IsEmpty());
  EXPECT_THAT(pair_measures({}, {}), IsEmpty());
}

}  // namespace
}  // namespace gonio::testing
