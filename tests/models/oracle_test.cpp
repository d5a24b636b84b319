// Why the oracle can be believed: values known by other means, normalisations that the formulas
// must have, two number types that agree, and a comparison that finds what it should.
#include "models/oracle/oracle.h"

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <numbers>
#include <random>

#include "models/harness/compare.h"
#include "models/oracle/cases.h"
#include "models/oracle/run.h"

namespace gonio::testing {
namespace {

using Long = long double;
using Vector = Vec<Long>;
constexpr Long kDegree = std::numbers::pi_v<Long> / 180;

Vector spherical(Long theta, Long phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double value(const MaterialSpec& spec, const Vector& wi, const Vector& wo) {
  const Oracle<Long> oracle(spec);
  std::vector<Long> f(oracle.channels());
  oracle.evaluate(wi, wo, f);
  return static_cast<double>(f[0]);
}

// The integral of g over the hemisphere: slopes tan(theta) from 1e-4 to 1e6 in equal ratios.
Long over_hemisphere(const std::function<Long(const Vector&)>& g) {
  constexpr int kSlopes = 600, kTurns = 720;
  const Long low = std::log(1e-4L), step = (std::log(1e6L) - low) / kSlopes;
  Long total = 0;
  for (int i = 0; i < kSlopes; ++i) {
    const Long slope = std::exp(low + (static_cast<Long>(i) + 0.5L) * step);
    const Long theta = std::atan(slope);
    const Long weight =
        std::sin(theta) * slope / (1 + slope * slope) * step * 360 * kDegree / kTurns;
    for (int j = 0; j < kTurns; ++j) {
      total += g(spherical(theta, (static_cast<Long>(j) + 0.5L) * 360 * kDegree / kTurns)) * weight;
    }
  }
  return total;
}

TEST(Oracle, HasTheKnownFresnelReflectances) {
  EXPECT_NEAR(static_cast<double>(dielectric<Long>(1, 1.5L)), 0.04, 1e-15);
  EXPECT_NEAR(static_cast<double>(dielectric<Long>(0, 1.5L)), 1, 1e-15);
  EXPECT_NEAR(static_cast<double>(dielectric<Long>(std::cos(75 * kDegree), 1.5L)), 0.2531, 5e-5);
  const Long brewster = std::atan(1.5L);  // no p-polarised light; rs = -cos(2 brewster)
  EXPECT_NEAR(static_cast<double>(dielectric<Long>(std::cos(brewster), 1.5L)),
              static_cast<double>(std::pow(std::cos(2 * brewster), 2.0L) / 2), 1e-15);
  EXPECT_EQ(dielectric<Long>(std::cos(42 * kDegree), 1 / 1.5L), 1);  // the critical angle is 41.8
  EXPECT_LT(dielectric<Long>(std::cos(41 * kDegree), 1 / 1.5L), 0.5L);
  // Normal incidence on a metal: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2).
  EXPECT_NEAR(static_cast<double>(conductor<Long>(1, 0.2L, 3.9L)), (0.64 + 15.21) / (1.44 + 15.21),
              1e-15);
  EXPECT_NEAR(static_cast<double>(conductor<Long>(0, 0.2L, 3.9L)), 1, 1e-15);
  EXPECT_NEAR(static_cast<double>(schlick<Long>(0.5L, 0.04L)), 0.04 + 0.96 / 32, 1e-15);
}

TEST(Oracle, TakesAConductorWithoutExtinctionForADielectric) {
  for (const Long eta : {0.3L, 0.8L, 1.0001L, 1.5L, 10.0L}) {
    for (Long c = 0.01L; c <= 1; c += 0.01L) {
      EXPECT_NEAR(static_cast<double>(conductor<Long>(c, eta, 0)),
                  static_cast<double>(dielectric<Long>(c, eta)), 1e-15);
    }
  }
}

TEST(Oracle, HasTheKnownValuesAtNormalIncidence) {
  const Vector n{0, 0, 1};
  const double pi = std::numbers::pi;
  EXPECT_NEAR(value(alone("lambertian", {{"rd", number(0.3)}}), n, n), 0.3 / pi, 1e-15);
  EXPECT_NEAR(value(alone("cook_torrance", {{"m", number(0.5)}}), n, n), 1 / (4 * pi * 0.25),
              1e-15);
  EXPECT_NEAR(value(alone("ggx", {{"alpha_x", number(0.5)}, {"alpha_y", number(0.2)}}), n, n),
              1 / (4 * pi * 0.1), 1e-14);
  EXPECT_NEAR(
      value(
          alone("ashikhmin_shirley",
                {{"nu", number(24)}, {"nv", number(99)}, {"rs", number(0.2)}, {"rd", number(0.5)}}),
          n, n),
      50 / (8 * pi) * 0.2 + 28 * 0.5 * 0.8 / (23 * pi) * (31.0 / 32) * (31.0 / 32), 1e-14);
}

TEST(Oracle, HasDistributionsThatAreNormalised) {
  for (const Long m : {0.05L, 0.3L, 1.0L, 2.0L}) {
    const auto d = [&](const Vector& h) { return beckmann(h, m) * h.z; };
    EXPECT_NEAR(static_cast<double>(over_hemisphere(d)), 1, 1e-4) << static_cast<double>(m);
  }
  for (const auto& [ax, ay] :
       {std::pair{0.05L, 0.05L}, std::pair{0.3L, 0.1L}, std::pair{1.0L, 0.5L}}) {
    const Long x = ax, y = ay;
    const auto d = [&](const Vector& h) { return trowbridge_reitz(h, x, y) * h.z; };
    EXPECT_NEAR(static_cast<double>(over_hemisphere(d)), 1, 1e-4);
  }
  // Ashikhmin and Shirley's p_h has (nu + 1)(nv + 1) under the root over 2 pi, not 8 pi.
  for (const auto& [nu, nv] : {std::pair{0.0L, 0.0L}, std::pair{10.0L, 1000.0L}}) {
    const Long u = nu, v = nv;
    const auto p = [&](const Vector& h) { return 4 * anisotropic_phong(h, u, v); };
    EXPECT_NEAR(static_cast<double>(over_hemisphere(p)), 1, 1e-4);
  }
}

// The visible microfacets fill the projected area of the surface: int D G1 (w.h)+ dh = n.w.
TEST(Oracle, HasTheMaskingThatBelongsToGgx) {
  for (const Long theta : {0.0L, 40.0L, 80.0L}) {
    const Vector w = spherical(theta * kDegree, 0.4L);
    const Long g1 = 1 / (1 + smith_lambda(w, 0.3L, 0.6L));
    const auto visible = [&](const Vector& h) {
      return trowbridge_reitz(h, 0.3L, 0.6L) * g1 * std::max(0.0L, dot(w, h));
    };
    EXPECT_NEAR(static_cast<double>(over_hemisphere(visible) / w.z), 1, 2e-4);
  }
}

// Models that pass through 0 on a surface of directions, where a sum of ones has no digit left.
bool vanishes(const std::string& model) {
  return model == "phong" || model == "phong_mix" || model == "oren_nayar";
}

// What long double gets wrong, 113 bits get wrong 2^49 times less: far below 3e-11.
TEST(Oracle, DoesNotDependOnItsOwnRounding) {
  auto pairs = hard_pairs<float>(7);
  std::shuffle(pairs.begin(), pairs.end(), std::mt19937(1));
  // Where bounds are stated; nearer to the horizon tan(theta) magnifies every rounding.
  std::erase_if(pairs, [](const auto& p) { return std::min(p.wi[2], p.wo[2]) < 1e-6F; });
  pairs.resize(3000);
  double worst = 0;
  for (const std::string& model : models_with_cases()) {
    for (const Case& c : cases_of(model)) {
      const auto truth = oracle_values(Oracle<Quad>(c.spec), pairs);
      const auto got = oracle_values(Oracle<Long>(c.spec), pairs);
      const Comparison result = compare<Long>(got, truth, vanishes(model) ? 1e-4 : 1e-30);
      worst = std::max(worst, result.worst);
      EXPECT_LE(result.worst, 1e-6) << model << " " << c.name;
      EXPECT_LE(result.p999, 1e-9) << model << " " << c.name;
    }
  }
  RecordProperty("long double against 113 bits", std::to_string(worst * 1e12) + "e-12");
  std::cout << "long double against 113 bits: worst " << worst << "\n";
}

class TheComparison : public ::testing::Test {
 protected:
  void SetUp() override {
    truth_ = oracle_values(Oracle<Quad>(cases_of("ggx")[0].spec), hard_pairs<float>(3));
    for (const Quad t : truth_) {
      got_.push_back(static_cast<float>(std::min(t, Quad(std::numeric_limits<float>::max()))));
    }
  }
  [[nodiscard]] Comparison run() const { return compare<float>(got_, truth_, 1e-30); }

  std::vector<Quad> truth_;
  std::vector<float> got_;
};

TEST_F(TheComparison, AcceptsRoundedTruth) {
  EXPECT_LE(run().worst, 6e-8);
  EXPECT_FALSE(run().improper_at) << run().improper;
  EXPECT_GT(run().checked, 10000U);
}

TEST_F(TheComparison, FindsAFactorOf1_00001) {
  for (float& v : got_) v = static_cast<float>(static_cast<double>(v) * 1.00001);
  EXPECT_GT(run().worst, 3e-6);
}

TEST_F(TheComparison, FindsOneWrongValue) {
  got_[1234] *= 1.00001F;
  EXPECT_GT(run().worst, 3e-6);
  EXPECT_EQ(run().worst_at, 1234U);
}

TEST_F(TheComparison, FindsWhatIsImproper) {
  EXPECT_EQ(improper(std::nanf(""), Quad(1), 1e-30), "NaN");
  EXPECT_EQ(improper(std::numeric_limits<float>::infinity(), Quad(1), 1e-30), "infinite");
  EXPECT_EQ(improper(-1e-20F, Quad(1), 1e-30), "negative");
  EXPECT_EQ(improper(-0.0F, Quad(1), 1e-30), "negative");
  EXPECT_EQ(improper(1e-20F, Quad(0), 1e-30), "not small where f is");
  EXPECT_EQ(improper(1e-20F, Quad(1e-31), 1e-30), "not small where f is");
  EXPECT_EQ(improper(1e30F, Quad(1e39), 1e-30), "not saturated where f is beyond the range");
  EXPECT_EQ(improper(std::numeric_limits<float>::max(), Quad(1e39), 1e-30), "");
}

}  // namespace
}  // namespace gonio::testing
