// Shapes, camera, samples and lights, without any material.
#include "client/picture/render/light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "client/picture/render/camera.h"
#include "client/picture/render/sequence.h"
#include "client/picture/render/shape.h"
#include "client/picture/render/sky.h"

namespace gonio::test {
namespace {

using namespace render;
using image::Image;
using std::numbers::pi;
using ::testing::AllOf;
using ::testing::HasSubstr;

Image some_map(int width, int height) {
  Image map(width, height);
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    const auto x = static_cast<float>((i * i + 3) % 11);
    map.pixels[i] = i % 5 == 2 ? Rgb(0, 0, 0) : Rgb(x, 0.5F * x + 0.1F, 2);
  }
  return map;
}

std::unique_ptr<const Light> dome(Image map) {
  auto light = dome_light(std::move(map), "map");
  EXPECT_TRUE(light.ok()) << light.error().message;
  return std::move(light).value();
}

TEST(Shape, FramesAreRightHandedAndFaceTheRay) {
  for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::cylinder, ShapeKind::plane}) {
    const auto shape = make_shape(kind);
    const Camera camera({.elevation = 35}, shape->radius(), 50, 50);
    int hits = 0;
    for (int i = 0; i < 2500; ++i) {
      const Ray ray = camera.ray(i % 50 + 0.5, i / 50 + 0.5);
      const auto frame = shape->hit(ray);
      if (!frame) continue;
      ++hits;
      EXPECT_NEAR(frame->u.norm(), 1, 1e-12);
      EXPECT_NEAR(frame->u.dot(frame->n), 0, 1e-12);
      EXPECT_NEAR((frame->u.cross(frame->v) - frame->n).norm(), 0, 1e-12);
      EXPECT_LT(frame->n.dot(ray.direction), 1e-9);
    }
    EXPECT_GT(hits, 400);
    EXPECT_LT(hits, 2500);
  }
}

TEST(Shape, TangentsFollowIt) {
  const auto sphere = make_shape(ShapeKind::sphere);
  const auto front = sphere->hit({{0, -5, 0}, {0, 1, 0}});
  ASSERT_TRUE(front);
  EXPECT_NEAR((front->n - Vec3(0, -1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((front->u - Vec3(1, 0, 0)).norm(), 0, 1e-12);  // east is to the right
  EXPECT_NEAR((front->v - Vec3(0, 0, 1)).norm(), 0, 1e-12);  // north is up
  EXPECT_FALSE(sphere->hit({{0, -5, 1.01}, {0, 1, 0}}));

  const auto cylinder = make_shape(ShapeKind::cylinder);
  const Vec3 axis = direction_of(pi / 2, radians(20));
  const auto side = cylinder->hit({{0, 0, 5}, {0, 0, -1}});
  ASSERT_TRUE(side);
  EXPECT_NEAR((side->n - Vec3(0, 0, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR((side->v - axis).norm(), 0, 1e-12);
  const auto end = cylinder->hit({5 * axis + Vec3(0, 0, 0.3), -axis});
  ASSERT_TRUE(end);
  EXPECT_NEAR((end->n - axis).norm(), 0, 1e-12);
  EXPECT_NEAR(std::abs(end->u.z()), 0, 1e-12);  // along the circle
  EXPECT_FALSE(cylinder->hit({5 * axis + Vec3(0, 0, 0.61), -axis}));

  const auto plane = make_shape(ShapeKind::plane);
  EXPECT_TRUE(plane->hit({{0.9, -0.9, 2}, {0, 0, -1}}));
  EXPECT_FALSE(plane->hit({{1.1, 0, 2}, {0, 0, -1}}));
  EXPECT_FALSE(plane->hit({{0, 0, -2}, {0, 0, 1}}));
}

TEST(Camera, SeesXOnTheRightAndTheSphereJustFits) {
  const auto sphere = make_shape(ShapeKind::sphere);
  for (const double field : {0.0, 30.0, 90.0}) {
    const Camera camera({.elevation = 20, .field_of_view = field}, 1, 200, 100);
    EXPECT_GT(camera.ray(150, 50).direction.x() + camera.ray(150, 50).origin.x(), 0);
    EXPECT_TRUE(sphere->hit(camera.ray(100, 50)));
    EXPECT_TRUE(sphere->hit(camera.ray(100, 10)));
    EXPECT_FALSE(sphere->hit(camera.ray(100, 0.1)));
    EXPECT_NEAR(
        (camera.ray(100, 50).direction - Vec3(0, std::cos(radians(20)), -std::sin(radians(20))))
            .norm(),
        0, 1e-12);
  }
}

// A (0,2)-sequence: of the first 256 samples each of the 16 x 16, 64 x 4 and 256 x 1 cells has one.
TEST(Sequence, IsStratifiedInEveryPixel) {
  for (std::uint32_t pixel = 0; pixel < 5; ++pixel) {
    const Sequence sequence(7, pixel);
    for (const int columns : {1, 4, 16, 64, 256}) {
      std::set<int> cells;
      for (std::uint32_t i = 0; i < 256; ++i) {
        const Xi xi = sequence.draw(i, 2);
        cells.insert(static_cast<int>(xi[0] * columns) * 1000 +
                     static_cast<int>(xi[1] * 256 / columns));
      }
      EXPECT_EQ(cells.size(), 256U) << columns;
    }
  }
}

TEST(Sequence, PurposesAreIndependent) {
  double product = 0;
  constexpr std::uint32_t kCount = 4096;
  const Sequence sequence(1, 1);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    product += (sequence.draw(i, 0)[0] - 0.5) * (sequence.draw(i, 1)[0] - 0.5);
  }
  EXPECT_NEAR(12 * product / kCount, 0, 5 / std::sqrt(kCount));
}

TEST(Dome, DensityIntegratesToOneAndIsThatOfTheSamples) {
  constexpr int kWidth = 8, kHeight = 5, kSamples = 200000;
  const Image map = some_map(kWidth, kHeight);
  const auto light = dome(map);
  std::vector<double> counts(map.pixels.size());
  for (int i = 0; i < kSamples; ++i) {
    // Any stratified numbers: every one of a lattice.
    const Xi xi = {(i + 0.5) / kSamples, std::fmod(i * 0.6180339887498949, 1.0)};
    const Vec3 w = light->sample(xi);
    EXPECT_NEAR(w.norm(), 1, 1e-12);
    const int column = static_cast<int>((std::atan2(w.x(), w.y()) / (2 * pi) + 0.5) * kWidth);
    const int row = static_cast<int>(std::acos(w.z()) / pi * kHeight);
    counts[static_cast<std::size_t>(row * kWidth + column)] += 1;
    EXPECT_TRUE((light->radiance(w) == map.at(column, row)).all());
  }
  double total = 0;
  for (int row = 0; row < kHeight; ++row) {
    const double solid_angle =
        2 * pi / kWidth * (std::cos(pi * row / kHeight) - std::cos(pi * (row + 1) / kHeight));
    for (int column = 0; column < kWidth; ++column) {
      const Vec3 middle = direction_of(pi * (row + 0.5) / kHeight,
                                       pi / 2 - 2 * pi * ((column + 0.5) / kWidth - 0.5));
      const double share = light->density(middle) * solid_angle;
      total += share;
      EXPECT_NEAR(counts[static_cast<std::size_t>(row * kWidth + column)] / kSamples, share, 1e-3)
          << column << " " << row;
    }
  }
  EXPECT_NEAR(total, 1, 1e-12);
}

TEST(Dome, MiddleIsAheadUpIsUpRightIsRight) {
  Image map(4, 3);
  for (Rgb& pixel : map.pixels) pixel = Rgb::Constant(1);
  map.at(2, 1) = Rgb(5, 0, 0);  // just right of the middle, at the horizon
  map.at(3, 0) = Rgb(0, 6, 0);
  const auto light = dome(map);
  EXPECT_EQ(light->radiance(Vec3(0.1, 1, 0).normalized())[0], 5);
  EXPECT_EQ(light->radiance(Vec3(-0.1, 1, 0).normalized())[0], 1);
  EXPECT_EQ(light->radiance(Vec3(0.1, -0.1, 1).normalized())[1], 6);
}

TEST(Dome, NamesTheTexelThatIsNoRadiance) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e-3F}) {
    Image map = some_map(8, 4);
    map.at(6, 2)[1] = bad;
    auto light = dome_light(std::move(map), "studio.exr");
    ASSERT_FALSE(light.ok());
    EXPECT_EQ(light.error().code, ErrorCode::invalid_argument);
    EXPECT_THAT(light.error().message,
                AllOf(HasSubstr("studio.exr: green of the texel in column 6, row 2"),
                      HasSubstr("allowed: finite numbers from 0")));
  }
  EXPECT_THAT(dome_light(Image(4, 2), "dark.pfm").error().message, HasSubstr("dark.pfm"));
}

TEST(Sky, IsAPositiveMapThatIsBrighterAbove) {
  const auto sky = dome(sky_map());
  const auto at = [&](double elevation) {
    return image::luminance(sky->radiance(direction_of(radians(90 - elevation), radians(60))));
  };
  EXPECT_GT(at(1), at(60));
  EXPECT_GT(at(60), at(-60));
  EXPECT_GT(at(-1), at(-60));
}

}  // namespace
}  // namespace gonio::test
