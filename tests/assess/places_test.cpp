// The catalogue: its pairs lie where it says, and are the same again.
#include "assess/places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "assess/assessed.h"
#include "numeric/direction.h"

namespace gonio::testing {
namespace {

using assess::Pair;
using assess::places;

std::size_t index_of(std::string_view name) {
  const auto found = std::ranges::find(places(), name, &assess::HardPlace::name);
  EXPECT_NE(found, places().end()) << name;
  return static_cast<std::size_t>(found - places().begin());
}

assess::Subject glass_from_inside() {
  return subject_of(
      material_of(alone("cook_torrance", {{"m", number(0.3)}, {"eta", number(0.6)}})));
}

std::vector<Pair> pairs_at(std::string_view name, std::size_t count = 2000) {
  return assess::pairs_at(index_of(name), glass_from_inside(), count, 1);
}

double length(const std::array<double, 3>& a) { return std::sqrt(gonio::dot(a, a)); }
double mirror_cosine(const Pair& p) {
  return p.wi[2] * p.wo[2] - p.wi[0] * p.wo[0] - p.wi[1] * p.wo[1];
}

TEST(Places, HaveNamesOfTheirOwnAndWords) {
  std::set<std::string_view> names;
  for (const assess::HardPlace& place : places()) {
    EXPECT_TRUE(names.insert(place.name).second) << place.name;
    EXPECT_FALSE(place.where.empty());
    EXPECT_FALSE(place.failure.empty());
  }
  EXPECT_GE(names.size(), 18U);
}

TEST(Places, AreTheSameForTheSameSeed) {
  const auto subject = glass_from_inside();
  for (std::size_t i = 0; i < places().size(); ++i) {
    const auto a = assess::pairs_at(i, subject, 50, 3), b = assess::pairs_at(i, subject, 50, 3),
               c = assess::pairs_at(i, subject, 50, 4);
    ASSERT_EQ(a.size(), 50U) << places()[i].name;
    EXPECT_EQ(a[49].wi, b[49].wi);
    EXPECT_EQ(a[49].wo, b[49].wo);
    EXPECT_NE(std::make_pair(a[49].wi, a[49].wo), std::make_pair(c[49].wi, c[49].wo))
        << places()[i].name;
  }
}

TEST(Places, AreWhatTheySay) {
  for (const Pair& p : pairs_at("exact_mirror")) {
    EXPECT_EQ(p.wi[0] + p.wo[0], 0);
    EXPECT_EQ(p.wi[1] + p.wo[1], 0);
  }
  for (const Pair& p : pairs_at("near_mirror")) EXPECT_GT(mirror_cosine(p), 1 - 1e-4);
  for (const Pair& p : pairs_at("across_mirror")) EXPECT_NEAR(mirror_cosine(p), 0, 1e-12);
  for (const Pair& p : pairs_at("retro")) EXPECT_GT(gonio::dot(p.wi, p.wo), 0.99);
  for (const Pair& p : pairs_at("same")) EXPECT_EQ(p.wi, p.wo);
  for (const Pair& p : pairs_at("grazing"))
    EXPECT_LE(std::min(p.wi[2], p.wo[2]), std::sin(10.0001 * 3.14159265 / 180));
  for (const Pair& p : pairs_at("exactly_opposite")) EXPECT_EQ(p.wi[2], -p.wo[2]);
  for (const Pair& p : pairs_at("opposite")) EXPECT_LT(gonio::dot(p.wi, p.wo), -0.999);
  for (const Pair& p : pairs_at("horizon")) {
    EXPECT_GT(std::min(p.wi[2], p.wo[2]), 0);
    EXPECT_LT(std::min(p.wi[2], p.wo[2]), 1e-6);
  }
  for (const Pair& p : pairs_at("below_horizon")) EXPECT_LE(std::min(p.wi[2], p.wo[2]), 0);
  for (const Pair& p : pairs_at("equal_angles")) EXPECT_NEAR(p.wi[2], p.wo[2], 1e-15);
  for (const Pair& p : pairs_at("axes")) EXPECT_TRUE(p.wi[0] == 0 || p.wi[1] == 0);
  for (const Pair& p : pairs_at("flat_half_vector"))
    EXPECT_LT(p.wi[2] + p.wo[2], 0.3 * length({p.wi[0] + p.wo[0], p.wi[1] + p.wo[1], 0}));
}

TEST(Places, AreAboveTheHorizonWhereThatIsNotTheirSubject) {
  for (const assess::HardPlace& place : places()) {
    const bool above = place.name != "below_horizon" && place.name != "exactly_opposite";
    for (const Pair& p : pairs_at(place.name, 500))
      EXPECT_EQ(std::min(p.wi[2], p.wo[2]) > 0, above) << place.name;
  }
}

TEST(Places, OffUnitReachesTheTolerance) {
  double shortest = 1, longest = 1;
  for (const Pair& p : pairs_at("off_unit")) {
    shortest = std::min(shortest, length(p.wi));
    longest = std::max(longest, length(p.wi));
  }
  EXPECT_LT(shortest, 1 - 9.8e-4);
  EXPECT_GT(longest, 1 + 9.8e-4);
  EXPECT_GT(shortest, 1 - 1e-3);
  EXPECT_LT(longest, 1 + 1e-3);
}

// cos(theta_d) = |wi + wo| / 2 is next to sqrt(1 - eta^2), on both sides.
TEST(Places, CriticalAngleIsThatOfTheMaterial) {
  int reflected = 0;
  const auto pairs = pairs_at("critical_angle");
  for (const Pair& p : pairs) {
    const double c = length({p.wi[0] + p.wo[0], p.wi[1] + p.wo[1], p.wi[2] + p.wo[2]}) / 2;
    EXPECT_NEAR(c, 0.8, 0.1001);
    reflected += c < 0.8 ? 1 : 0;
  }
  EXPECT_GT(reflected, 500);
  EXPECT_LT(reflected, 1500);
  const auto air = subject_of(material_of(alone("cook_torrance", {{"eta", number(1.5)}})));
  EXPECT_TRUE(assess::pairs_at(index_of("critical_angle"), air, 10, 1).empty());
}

TEST(Places, RoundToFloat32) {
  for (const std::size_t size : {1, 2, 3, 5, 4001}) {
    for (const Pair& p : assess::rounded(pairs_at("hemisphere", size))) {
      for (const auto& w : {p.wi, p.wo}) {
        for (const double x : w) {
          const volatile float narrow = static_cast<float>(x);
          ASSERT_EQ(x, static_cast<double>(narrow)) << size;
        }
      }
    }
  }
}

}  // namespace
}  // namespace gonio::testing
