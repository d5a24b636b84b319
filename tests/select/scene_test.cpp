#include "select/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "select/error/distribution.h"
#include "select/trials.h"

namespace gonio::testing {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void expect_error(const select::Scene& scene, const char* field, const char* value) {
  const Outcome found = check(scene);
  ASSERT_FALSE(found.ok()) << field;
  EXPECT_EQ(found.error().field, field);
  EXPECT_THAT(found.error().value, HasSubstr(value));
  EXPECT_FALSE(found.error().allowed.empty());
}

TEST(Scene, NamesWhatIsWrong) {
  expect_error({}, "scene", "empty");
  expect_error(scene_to(75, 0), "scene.tolerance", "0");
  expect_error(scene_to(75, -0.1), "scene.tolerance", "-0.1");
  expect_error(scene_to(75, kNan), "scene.tolerance", "nan");
  expect_error(scene_to(91, 0.1), "scene.theta_i", "[0, 91]");
  select::Scene scene = scene_to(75, 0.1);
  scene.bins[0].theta_o = {1, 0.5};
  expect_error(scene, "scene.theta_o", "[57.2958, 28.6479]");
  scene.bins[0].theta_o = {0, kNan};
  expect_error(scene, "scene.theta_o", "nan");
  scene = scene_to(75, 0.1);
  scene.bins.push_back(scene.bins[0]);
  scene.bins[1].phi = {2, 2};
  expect_error(scene, "scene.bins[1].phi", "114.592");
  scene = scene_to(75, 0.1);
  scene.confidence = 1;
  expect_error(scene, "scene.confidence", "1");
  scene = scene_to(75, 0.1);
  scene.cost = select::CostKind::ns_variance;
  expect_error(scene, "scene.cost", "directional");
  EXPECT_TRUE(check(scene_to(90, 0.1)).ok());
}

TEST(Scene, HistogramsBecomeBins) {
  const auto bins = select::bins_of({0, 0.5, 1}, {0, 1}, {0, 1, pi}, {1, 0, 2, 3});
  ASSERT_TRUE(bins.ok()) << bins.error().message;
  ASSERT_EQ(bins->size(), 3U);
  EXPECT_EQ((*bins)[1].theta_i.lower, 0.5);
  EXPECT_EQ((*bins)[1].phi.upper, 1);
  EXPECT_EQ((*bins)[2].weight, 3);
  const auto field = [](const auto& result) { return result.error().field; };
  EXPECT_EQ(field(select::bins_of({0}, {0, 1}, {0, 1}, {1})), "scene.histogram.theta_i");
  EXPECT_EQ(field(select::bins_of({0, 1}, {1, 0}, {0, 1}, {1})), "scene.histogram.theta_o");
  EXPECT_EQ(field(select::bins_of({0, 1}, {0, 1}, {0, 4}, {1})), "scene.histogram.phi");
  EXPECT_EQ(field(select::bins_of({0, 1}, {0, 1}, {0, 1}, {1, 2})), "scene.histogram.counts");
  EXPECT_EQ(field(select::bins_of({0, 1}, {0, 1}, {0, 1}, {0})), "scene.histogram.counts");
  EXPECT_EQ(field(select::bins_of({0, 1}, {0, 1}, {0, 1}, {-1})), "scene.histogram.counts");
  EXPECT_EQ(field(select::bins_of({0, 0.5, 1}, {0, 1}, {0, 1}, {1e308, 1e308})),
            "scene.histogram.counts");
}

TEST(Scene, HasOnlySoManyBins) {
  select::Scene scene = scene_to(60, 0.1);
  scene.bins.resize(select::kMostBins, scene.bins.front());
  EXPECT_TRUE(check(scene).ok());
  scene.bins.push_back(scene.bins.front());
  EXPECT_EQ(check(scene).error().field, "scene.bins");
}

Direction direction(double theta, double phi) {
  const auto rounded = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  return {rounded(std::sin(theta) * std::cos(phi)), rounded(std::sin(theta) * std::sin(phi)),
          rounded(std::cos(theta))};
}

// One range, cut into bins of the same density whose edges are where a goniometer measures: what
// lies on them counts once, and the range's ends belong to it.
TEST(Distribution, OfBinsIsThatOfTheWhole) {
  select::Scene whole = scene_to(75, 0.1), cut = whole;
  cut.bins.clear();
  const double degree = pi / 180;
  for (const auto& [i, j] : {std::pair{0.0, 30.0}, {30.0, 75.0}}) {
    for (const auto& [k, l] : {std::pair{0.0, 45.0}, {45.0, 75.0}}) {
      for (const auto& [m, n] : {std::pair{0.0, 90.0}, {90.0, 180.0}}) {
        const double size = (std::cos(i * degree) - std::cos(j * degree)) *
                            (std::cos(k * degree) - std::cos(l * degree)) * (n - m);
        cut.bins.push_back(
            {{i * degree, j * degree}, {k * degree, l * degree}, {m * degree, n * degree}, size});
      }
    }
  }
  const select::Distribution one(whole), many(cut);
  for (int i = 0; i <= 75; i += 15) {
    for (int o = 0; o <= 75; o += 15) {
      for (int phi = 0; phi <= 180; phi += 45) {
        const Direction wi = direction(i * degree, 0.3),
                        wo = direction(o * degree, 0.3 + phi * degree);
        const double density = one.density(wi, wo);
        EXPECT_GT(density, 0) << i << " " << o << " " << phi;
        EXPECT_NEAR(many.density(wi, wo), density, 1e-9 * density) << i << " " << o << " " << phi;
      }
    }
  }
}

// Where light comes along the normal nothing has an azimuth: the mean of what bins say.
TEST(Distribution, AtTheNormalIsTheMeanOverAzimuths) {
  select::Scene scene = scene_to(75, 0.1);
  scene.bins = {{{0, 1}, {0, 1}, {0, pi / 2}, 3}, {{0, 1}, {0, 1}, {pi / 2, pi}, 1}};
  const select::Distribution distribution(scene);
  const Direction light{0.5, 0, std::sqrt(0.75)};
  const double toward = distribution.density(light, light),
               away = distribution.density(light, {-0.5, 0, std::sqrt(0.75)});
  EXPECT_NEAR(toward, 3 * away, 1e-9);
  for (const double zero : {0.0, -0.0})
    EXPECT_NEAR(distribution.density({zero, zero, 1}, light), (toward + away) / 2, 1e-9);
}

// Drawn pairs are in the scene, and the mean of 1 over their density is the measure of the scene's
// pairs.
TEST(Distribution, DrawsByItsDensity) {
  select::Scene scene = scene_to(60, 0.1);
  scene.bins.push_back({{0.5, 1.2}, {0.2, 0.4}, {0, 1}, 3});
  const select::Distribution distribution(scene);
  std::mt19937_64 random(1);
  double sum = 0;
  constexpr int kDraws = 200'000;
  for (int i = 0; i < kDraws; ++i) {
    const auto [wi, wo] = distribution.draw(random);
    const double density = distribution.density(wi, wo);
    ASSERT_GT(density, 0);
    ASSERT_GE(distribution.incident_density(wi), 0.99 / (2 * pi) / 4);
    sum += 1 / density;
  }
  // The first bin, and what of the second is outside it: theta_i above 60 degrees.
  const double half = 1 - std::cos(pi / 3), more = std::cos(pi / 3) - std::cos(1.2),
               narrow = std::cos(0.2) - std::cos(0.4);
  const double measure = 4 * pi * pi * half * half + 2 * pi * more * narrow * 2;
  EXPECT_NEAR(sum / kDraws, measure, 0.02 * measure);
}

}  // namespace
}  // namespace gonio::testing
