// Pictures by way of the service, against what is known of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "client/picture/render/evaluator.h"
#include "client/picture/render/integrator.h"
#include "client/support/server_fixture.h"

namespace gonio::test {
namespace {

using namespace render;
using client::Material;
using image::Image;
using std::numbers::pi;
using ::testing::HasSubstr;

class Render : public ServerFixture {
 protected:
  struct Setting {
    ShapeKind shape = ShapeKind::sphere;
    View view{.elevation = 0, .field_of_view = 0};
    int side = 32, samples = 16;
    std::uint32_t seed = 0;
    int threads = 1;
    std::string transport = "in-process";
    std::optional<Rgb> background = Rgb::Zero();
  };

  Image picture(const Material& material, const Light& light, const Setting& setting) {
    const auto client = connect(setting.transport);
    auto evaluator = Evaluator::create(client, material);
    EXPECT_TRUE(evaluator.ok()) << evaluator.error().message;
    const auto shape = make_shape(setting.shape);
    const Camera camera(setting.view, shape->radius(), setting.side, setting.side);
    double done = 0;
    auto image = render::render({*shape, camera, light, setting.background},
                                {setting.side, setting.side, setting.samples, setting.seed,
                                 Technique::both, setting.threads},
                                *evaluator, [&](double share) { done = share; });
    EXPECT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(done, 1);
    EXPECT_EQ(evaluator->report().flagged, 0U);
    return std::move(image).value();
  }

  static Material lambertian(std::vector<double> rd) {
    return Material::model("lambertian", {{"rd", std::move(rd)}});
  }

  static std::unique_ptr<const Light> dome(Image map) {
    auto light = dome_light(std::move(map), "map");
    EXPECT_TRUE(light.ok()) << light.error().message;
    return std::move(light).value();
  }
};

// Orthographic and from the side, pixel (x, y) sees the normal (x, -z, y).
TEST_F(Render, LambertianSphereIsItsCosine) {
  const Vec3 to_light = Vec3(0.5, -0.6, 0.7).normalized();
  const std::vector<double> rd = {0.8, 0.5, 0.1};
  constexpr int kSide = 32, kFine = 64;
  const Image image =
      picture(lambertian(rd), *directional_light(to_light), {.side = kSide, .samples = 256});
  const double pixel = 2 * 1.06 / kSide;
  int compared = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double left = (i % kSide - kSide / 2) * pixel, top = (kSide / 2 - i / kSide) * pixel;
    if (std::hypot(std::abs(left + pixel / 2), std::abs(top - pixel / 2)) > 1 - pixel) continue;
    double cosine = 0;  // its mean over the pixel
    for (int k = 0; k < kFine * kFine; ++k) {
      const double x = left + (k % kFine + 0.5) * pixel / kFine;
      const double z = top - (k / kFine + 0.5) * pixel / kFine;
      const Vec3 normal(x, -std::sqrt(1 - x * x - z * z), z);
      cosine += std::max(0.0, normal.dot(to_light)) / (kFine * kFine);
    }
    for (int channel = 0; channel < 3; ++channel) {
      const double expected = rd[static_cast<std::size_t>(channel)] / pi * cosine * pi;
      EXPECT_NEAR(image.at(i % kSide, i / kSide)[channel], expected, 1e-3) << i;
    }
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

TEST_F(Render, LightFromBelowLightsFromBelow) {
  const Image image = picture(lambertian({1}), *directional_light(Vec3(0, 0, -1)), {.samples = 4});
  EXPECT_EQ(image.at(16, 5)[0], 0);
  EXPECT_GT(image.at(16, 27)[0], 0.5F);
}

// A white furnace: what reflects everything vanishes before a sky that is everywhere the same.
TEST_F(Render, WhiteVanishesInAFurnace) {
  Image map(6, 3);
  for (Rgb& pixel : map.pixels) pixel = Rgb::Constant(1);
  const auto light = dome(map);
  for (const ShapeKind shape : {ShapeKind::sphere, ShapeKind::cylinder, ShapeKind::plane}) {
    const Image image =
        picture(lambertian({1, 1, 1}), *light,
                {.shape = shape, .view = {.elevation = 25}, .samples = 256, .background = {}});
    double sum = 0;
    for (const Rgb& pixel : image.pixels) {
      EXPECT_NEAR(pixel[0], 1, 0.06);  // six standard deviations
      sum += pixel.mean();
    }
    EXPECT_NEAR(sum / static_cast<double>(image.pixels.size()), 1, 3e-4);
  }
}

// The irradiance of each texel is known in closed form: that of the plane is their sum.
TEST_F(Render, PlaneUnderAMapHasTheMapsIrradiance) {
  constexpr int kWidth = 16, kHeight = 8;
  Image map(kWidth, kHeight);
  double expected = 0;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const float radiance = (row * 7 + column * 3) % 10 == 0 ? 40.0F : 0.1F;
      map.at(column, row) = Rgb::Constant(radiance);
      if (row >= kHeight / 2) continue;
      const double above = std::sin(pi * row / kHeight), below = std::sin(pi * (row + 1) / kHeight);
      expected += radiance * (2 * pi / kWidth) * (below * below - above * above) / 2;
    }
  }
  const Image image = picture(lambertian({0.5}), *dome(map),
                              {.shape = ShapeKind::plane,
                               .view = {.elevation = 90, .field_of_view = 0, .zoom = 4},
                               .samples = 256});
  double mean = 0;
  for (const Rgb& pixel : image.pixels) mean += pixel[0] / static_cast<double>(image.pixels.size());
  EXPECT_NEAR(mean / (0.5 / pi * expected), 1, 1e-3);
}

// Where the normal is halfway between light and viewer.
TEST_F(Render, HighlightIsAtTheHalfVector) {
  const Vec3 to_light = Vec3(0.6, -0.7, 0.3).normalized();
  constexpr int kSide = 101;
  const Image image = picture(Material::model("ggx", {{"alpha_x", 0.05}, {"alpha_y", 0.05}}),
                              *directional_light(to_light), {.side = kSide});
  const Vec3 half = (to_light + Vec3(0, -1, 0)).normalized();
  int best = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    if (image.pixels[static_cast<std::size_t>(i)][0] >
        image.pixels[static_cast<std::size_t>(best)][0]) {
      best = i;
    }
  }
  const double scale = kSide / (2 * 1.06);
  EXPECT_NEAR(best % kSide, kSide / 2.0 + half.x() * scale, 1.5);
  EXPECT_NEAR(best / kSide, kSide / 2.0 - half.z() * scale, 1.5);
}

// A small exponent along a tangent is a wide lobe along it. Seen along the light, the highlight is
// in the middle, u to the right and v up.
TEST_F(Render, AnisotropicHighlightFollowsTheTangents) {
  const auto spread = [&](double nu, double nv) {
    const Material material =
        Material::model("ashikhmin_shirley", {{"rd", 0.0}, {"rs", 0.9}, {"nu", nu}, {"nv", nv}});
    const Image image = picture(material, *directional_light(Vec3(0, -1, 0)), {.side = 64});
    double x2 = 0, y2 = 0;
    for (int i = 0; i < 64 * 64; ++i) {
      const double x = i % 64 - 31.5, y = i / 64 - 31.5, f = image.at(i % 64, i / 64)[0];
      x2 += f * x * x;
      y2 += f * y * y;
    }
    return x2 / y2;
  };
  EXPECT_GT(spread(10, 400), 8);
  EXPECT_LT(spread(400, 10), 1 / 8.0);
  EXPECT_NEAR(spread(50, 50), 1, 0.1);
}

TEST_F(Render, SameSeedSameBits) {
  const auto light = dome([] {
    Image map(4, 2);
    for (std::size_t i = 0; i < 8; ++i) map.pixels[i] = Rgb(1, static_cast<float>(i), 0.5F);
    return map;
  }());
  const auto bits = [&](const Setting& setting) {
    const Image image = picture(ggx(), *light, setting);
    return std::vector<float>(image.pixels.front().data(),
                              image.pixels.front().data() + 3 * image.pixels.size());
  };
  const Setting one{.side = 96, .samples = 17};
  Setting other = one;
  other.threads = 3;
  other.transport = "unix";
  EXPECT_EQ(bits(one), bits(other));
  other.seed = 1;
  EXPECT_NE(bits(one), bits(other));
}

TEST_F(Render, OtherNumbersOfChannelsAreRefused) {
  const auto client = connect("in-process");
  auto evaluator = Evaluator::create(client, lambertian({0.1, 0.2, 0.3, 0.4}));
  ASSERT_FALSE(evaluator.ok());
  EXPECT_THAT(evaluator.error().message, HasSubstr("of 4 channels"));
  EXPECT_FALSE(Evaluator::create(client, Material::model("nothing")).ok());
}

}  // namespace
}  // namespace gonio::test
