// Grids: nesting, frames, the horizon, ranges, and what is refused.
#include "gonio/engine/grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace gonio {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
constexpr double kPi = std::numbers::pi;
using Vector = Eigen::Vector3d;

struct Pairs {
  std::vector<double> wi, wo;
  [[nodiscard]] Vector in(std::size_t i) const { return {wi[3 * i], wi[3 * i + 1], wi[3 * i + 2]}; }
  [[nodiscard]] Vector out(std::size_t i) const {
    return {wo[3 * i], wo[3 * i + 1], wo[3 * i + 2]};
  }
};

Pairs expand_all(const Grid& grid) {
  Pairs pairs{std::vector<double>(3 * grid.size()), std::vector<double>(3 * grid.size())};
  grid.expand(0, grid.size(), pairs.wi.data(), pairs.wo.data());
  return pairs;
}

Vector spherical(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

TEST(SphericalGrid, NestsWithTheLastAxisFastest) {
  const std::vector<double> ti{0.1, 0.2}, pi{0.3, 0.4, 0.5}, to{0.6, 0.7}, po{-1, 0, 1, 2};
  const auto grid = Grid::spherical(ti, pi, to, po);
  ASSERT_TRUE(grid.ok());
  ASSERT_EQ(grid->size(), 48U);
  const Pairs pairs = expand_all(*grid);
  std::size_t at = 0;
  for (const double a : ti) {
    for (const double b : pi) {
      for (const double c : to) {
        for (const double d : po) {
          EXPECT_LE((pairs.in(at)-spherical(a, b)).norm(), 1e-15) << at;
          EXPECT_LE((pairs.out(at) - spherical(c, d)).norm(), 1e-15) << at;
          ++at;
        }
      }
    }
  }
}

TEST(HalfAngleGrid, GivesTheAnglesThatWereAsked) {
  const std::vector<double> th{0.0, 0.3, 1.2}, td{0.0, 0.4, 1.0, 1.5}, pd{0.0, 0.7, 1.6, 3.0};
  const auto grid = Grid::half_angle(th, td, pd);
  ASSERT_TRUE(grid.ok());
  ASSERT_EQ(grid->size(), 48U);
  const Pairs pairs = expand_all(*grid);
  for (std::size_t i = 0; i < 48; ++i) {
    const double h_want = th[i / 16], d_want = td[i / 4 % 4], p_want = pd[i % 4];
    const Vector half = (pairs.in(i) + pairs.out(i)).normalized();
    EXPECT_LE((half - spherical(h_want, 0)).norm(), 2e-15) << i;  // phi_h = 0
    // Rusinkiewicz' difference direction: wi with the half-vector turned back onto the normal.
    const Vector d = Eigen::AngleAxisd(-h_want, Vector::UnitY()) * pairs.in(i);
    EXPECT_LE((d - spherical(d_want, p_want)).norm(), 1e-15) << i;
    EXPECT_NEAR(pairs.out(i).norm(), 1, 1e-15);
  }
}

TEST(Grid, TakesNinetyDegreesAsTheHorizon) {
  const double right_angle = 90 * kPi / 180;
  const auto grid =
      Grid::spherical({right_angle, -right_angle}, {0, 1}, {right_angle, 3 * right_angle}, {0, 2});
  ASSERT_TRUE(grid.ok());
  const Pairs pairs = expand_all(*grid);
  for (std::size_t i = 0; i < grid->size(); ++i) {
    EXPECT_EQ(pairs.in(i).z(), 0) << i;
    EXPECT_EQ(pairs.out(i).z(), 0) << i;
  }
  const auto near = Grid::spherical({right_angle - 1e-15, right_angle + 1e-15}, {0}, {0}, {0});
  ASSERT_TRUE(near.ok());
  EXPECT_GT(expand_all(*near).in(0).z(), 0);
  EXPECT_LT(expand_all(*near).in(1).z(), 0);
}

TEST(HalfAngleGrid, TakesComplementaryAnglesAsTheHorizon) {
  for (int degrees = 0; degrees <= 90; ++degrees) {
    const auto grid =
        Grid::half_angle({degrees * kPi / 180}, {(90 - degrees) * kPi / 180}, {0.0, kPi});
    ASSERT_TRUE(grid.ok());
    const Pairs pairs = expand_all(*grid);
    EXPECT_EQ(pairs.in(0).z(), 0) << degrees;
    EXPECT_EQ(pairs.out(1).z(), 0) << degrees;
  }
}

TEST(Grid, GivesTheSameForEveryRangeAndType) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-2, 2);
  const auto axis = [&](int n) {
    std::vector<double> angles(static_cast<std::size_t>(n));
    for (double& a : angles) a = angle(random);
    return angles;
  };
  for (const auto& grid : {Grid::spherical(axis(3), axis(5), axis(2), axis(7)),
                           Grid::half_angle(axis(6), axis(1), axis(35))}) {
    ASSERT_TRUE(grid.ok());
    ASSERT_EQ(grid->size(), 210U);
    const Pairs all = expand_all(*grid);
    for (std::size_t first = 0; first <= 210; ++first) {
      for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{8}}) {
        if (first + count > 210) continue;
        std::vector<double> wi(24), wo(24);
        std::vector<float> wi_f(24), wo_f(24);
        grid->expand(first, count, wi.data(), wo.data());
        grid->expand(first, count, wi_f.data(), wo_f.data());
        for (std::size_t k = 0; k < 3 * count; ++k) {
          ASSERT_EQ(wi[k], all.wi[3 * first + k]);
          ASSERT_EQ(wo[k], all.wo[3 * first + k]);
          ASSERT_EQ(wi_f[k], static_cast<float>(wi[k]));
          ASSERT_EQ(wo_f[k], static_cast<float>(wo[k]));
        }
      }
    }
  }
}

TEST(Grid, ReachesItsFarEndWithoutExpandingTheRest) {
  const std::vector<double> axis(100000, 0.5);
  std::vector<double> last = axis;
  last.back() = 0.25;
  const auto grid = Grid::spherical(last, axis, axis, {0.1});
  ASSERT_TRUE(grid.ok());
  ASSERT_EQ(grid->size(), 1000000000000000U);
  std::array<double, 3> wi{}, wo{};
  grid->expand(grid->size() - 1, 1, wi.data(), wo.data());
  EXPECT_EQ(wi[2], std::cos(0.25));
  EXPECT_EQ(wo[2], std::cos(0.5));
}

TEST(Grid, RefusesAnEmptyAxisByName) {
  const auto spherical = Grid::spherical({0}, {0}, {}, {0});
  ASSERT_FALSE(spherical.ok());
  EXPECT_EQ(spherical.error().field, "theta_o");
  const auto half_angle = Grid::half_angle({0}, {0}, {});
  ASSERT_FALSE(half_angle.ok());
  EXPECT_EQ(half_angle.error().field, "phi_d");
  EXPECT_THAT(half_angle.error().message, HasSubstr("empty"));
}

TEST(Grid, RefusesAngleThatIsNotFiniteByPlace) {
  const auto nan = Grid::spherical({0}, {0, 1, std::nan("")}, {0}, {0});
  ASSERT_FALSE(nan.ok());
  EXPECT_EQ(nan.error().field, "phi_i[2]");
  EXPECT_EQ(nan.error().code, ErrorCode::invalid_argument);
  const auto infinite = Grid::half_angle({0, -std::numeric_limits<double>::infinity()}, {0}, {0});
  ASSERT_FALSE(infinite.ok());
  EXPECT_THAT(infinite.error().message,
              AllOf(HasSubstr("theta_h[1]"), HasSubstr("-inf"), HasSubstr("finite")));
}

TEST(Grid, RefusesMoreThanTwoToThe63Pairs) {
  const std::vector<double> axis(std::size_t{1} << 16, 0.0);
  const auto fits = Grid::spherical(axis, axis, axis, std::vector<double>(1 << 15, 0.0));
  ASSERT_TRUE(fits.ok());
  EXPECT_EQ(fits->size(), std::uint64_t{1} << 63);
  const auto too_large = Grid::spherical(axis, axis, axis, std::vector<double>((1 << 15) + 1, 0.0));
  ASSERT_FALSE(too_large.ok());
  EXPECT_EQ(too_large.error().code, ErrorCode::resource_exhausted);
  EXPECT_THAT(too_large.error().message,
              AllOf(HasSubstr("65536 x 65536 x 65536 x 32769"), HasSubstr("2^63")));
  EXPECT_FALSE(Grid::spherical(axis, axis, axis, axis).ok());  // 2^64 wraps to 0
}

}  // namespace
}  // namespace gonio
