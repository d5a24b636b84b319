// The pictures of lobes: scales, curves, hemispheres.
#include "client/picture/lobe/lobe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/picture/lobe/picture.h"
#include "client/support/server_fixture.h"

namespace gonio::test {
namespace {

using client::Material;
using lobe::Scale;
using lobe::ScaleKind;
using std::numbers::pi;

TEST(LobeScale, EndsAtARoundNumber) {
  const Scale linear(ScaleKind::linear, 0, 3.7);
  EXPECT_DOUBLE_EQ(linear.position(5), 1);
  EXPECT_DOUBLE_EQ(linear.position(2.5), 0.5);
  EXPECT_DOUBLE_EQ(linear.position(-1), 0);
  EXPECT_EQ(linear.ticks().back().label, "5");
  const Scale cube_root(ScaleKind::cbrt, 0, 1000);
  EXPECT_DOUBLE_EQ(cube_root.position(125), 0.5);
  const Scale log(ScaleKind::log, 0.02, 30);
  EXPECT_DOUBLE_EQ(log.position(100), 1);
  EXPECT_DOUBLE_EQ(log.position(1), 0.5);
  EXPECT_DOUBLE_EQ(log.position(1e-9), 0);
  EXPECT_EQ(log.ticks().size(), 4U);
  EXPECT_EQ(Scale(ScaleKind::log, 1, 3e7).ticks().back().label, "10⁸");
}

class Lobe : public ServerFixture {
 protected:
  void SetUp() override {
    ServerFixture::SetUp();
    client_.emplace(connect("in-process"));
  }

  render::Evaluator evaluator(const Material& material) {
    auto made = render::Evaluator::create(*client_, material);
    EXPECT_TRUE(made.ok()) << made.error().message;
    return std::move(made).value();
  }

  std::optional<client::Client> client_;
};

TEST_F(Lobe, LambertianIsConstantAndItsCosineIsACosine) {
  auto white = evaluator(Material::model("lambertian", {{"rd", 1.0}}));
  auto flat = lobe::curve_of({.theta_i = 40, .phi_i = 180}, white);
  ASSERT_TRUE(flat.ok()) << flat.error().message;
  auto cosine = lobe::curve_of({.theta_i = 40, .phi_i = 180, .cosine = true}, white);
  ASSERT_TRUE(cosine.ok());
  EXPECT_LT(flat->theta_o.front(), -89.9);
  EXPECT_GT(flat->theta_o.back(), 89.9);
  EXPECT_TRUE(std::is_sorted(flat->theta_o.begin(), flat->theta_o.end()));
  for (std::size_t i = 0; i < flat->values.size(); ++i) {
    EXPECT_NEAR(flat->values[i][0], 1 / pi, 1e-6);
    EXPECT_NEAR(cosine->values[i][0], std::cos(flat->theta_o[i] * pi / 180) / pi, 1e-6);
  }
}

// A lobe of a twentieth of a degree is met, on the side away from the light.
TEST_F(Lobe, NarrowLobeIsNotMissed) {
  auto mirror =
      evaluator(Material::model("ggx", {{"f0", 1.0}, {"alpha_x", 1e-3}, {"alpha_y", 1e-3}}));
  auto curve = lobe::curve_of({.theta_i = 33.333, .phi_i = 70}, mirror);
  ASSERT_TRUE(curve.ok());
  const auto peak = std::max_element(curve->values.begin(), curve->values.end(),
                                     [](const auto& a, const auto& b) { return a[0] < b[0]; });
  const auto at = static_cast<std::size_t>(peak - curve->values.begin());
  EXPECT_NEAR(curve->theta_o[at], 33.333, 0.01);
  // D(n) = 1 / (pi alpha^2), F = 1, G about 1: f = D / (4 cos^2).
  const double cosine = std::cos(33.333 * pi / 180);
  EXPECT_NEAR((*peak)[0] / (1 / (pi * 1e-6) / (4 * cosine * cosine)), 1, 0.01);
}

TEST_F(Lobe, HemisphereHasTheMirrorsDirectionOnItsRightAtAnyAzimuth) {
  auto glossy =
      evaluator(Material::model("ggx", {{"f0", 1.0}, {"alpha_x", 0.05}, {"alpha_y", 0.05}}));
  for (const double phi : {0.0, 75.0, 180.0}) {
    constexpr int kSide = 41;
    auto values = lobe::hemisphere_of({.theta_i = 30, .phi_i = phi}, kSide, glossy);
    ASSERT_TRUE(values.ok()) << values.error().message;
    const auto peak = std::max_element(values->begin(), values->end(),
                                       [](const auto& a, const auto& b) { return a[0] < b[0]; });
    const auto at = static_cast<int>(peak - values->begin());
    EXPECT_NEAR(at % kSide, kSide / 2.0 * 1.5 - 0.5, 1);  // sin 30 degrees of the radius
    EXPECT_EQ(at / kSide, kSide / 2);
  }
}

// A wide lobe along u shows along u: across the picture if light comes along u, else upright.
TEST_F(Lobe, AnisotropyTurnsWithTheAzimuth) {
  auto brushed = evaluator(Material::model(
      "ashikhmin_shirley", {{"rd", 0.0}, {"rs", 0.9}, {"nu", 10.0}, {"nv", 400.0}}));
  const auto spread = [&](double phi) {
    constexpr int kSide = 61;
    auto values = lobe::hemisphere_of({.theta_i = 0, .phi_i = phi, .cosine = true}, kSide, brushed);
    EXPECT_TRUE(values.ok());
    double x2 = 0, y2 = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
      const double x = i % kSide - 30, y = i / kSide - 30;
      const double f = (*values)[static_cast<std::size_t>(i)][0];
      x2 += f * x * x;
      y2 += f * y * y;
    }
    return x2 / y2;
  };
  EXPECT_GT(spread(180), 4);
  EXPECT_LT(spread(90), 0.25);
}

TEST_F(Lobe, PictureIsDrawn) {
  auto copper = evaluator(ggx());
  auto rgb = lobe::draw_lobes({.width = 300, .height = 200, .title = "copper", .theta_i = {30, 60}},
                              copper);
  ASSERT_TRUE(rgb.ok()) << rgb.error().message;
  ASSERT_EQ(rgb->size(), 3U * 300 * 200);
  EXPECT_EQ(rgb->front(), 255);  // paper
  EXPECT_GT(std::count_if(rgb->begin(), rgb->end(), [](int byte) { return byte < 128; }), 5000);
}

TEST_F(Lobe, BlackIsDrawnToo) {
  auto black = evaluator(Material::model("lambertian", {{"rd", 0.0}}));
  for (const ScaleKind scale : {ScaleKind::log, ScaleKind::linear, ScaleKind::cbrt}) {
    EXPECT_TRUE(
        lobe::draw_lobes(
            {.width = 100, .height = 100, .title = "black", .theta_i = {0}, .scale = scale}, black)
            .ok());
  }
}

}  // namespace
}  // namespace gonio::test
