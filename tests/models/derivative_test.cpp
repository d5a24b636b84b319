// What a derivative is taken by, and of what. That its values are right is the harness's to say.
#include "engine/material/derivative.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/harness/harness.h"
#include "models/oracle/run.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;

const MaterialSpec kSum{
    {},
    LobeSpec{"lambertian", {{"rd", std::vector{0.1, 0.2, 0.3}}}},
    {LobeSpec{"ggx", {{"alpha_x", number(0.2)}}}, LobeSpec{"phong", {{"s", number(20)}}}}};

TEST(Derivative, OfASumIsThatOfTheLobe) {
  const std::vector<DirectionPair<double>> pair{{{0.6, 0, 0.8}, {0, 0.6, 0.8}, PairKind::special}};
  const auto of_sum = library_derivative(kSum, "specular[1].parameters.s", pair, best_isa());
  const MaterialSpec lobe{kSum.specular[1], {}, {}};
  const auto of_lobe = library_derivative(lobe, "parameters.s", pair, best_isa());
  ASSERT_EQ(of_sum.size(), 3U);
  for (const double d : of_sum) EXPECT_EQ(d, of_lobe[0]);
  const auto of_base = library_derivative(kSum, "diffuse.parameters.rd", pair, best_isa());
  for (const double d : of_base) EXPECT_NEAR(d, 0.318309886183790672, 1e-15);
}

// By the rotation all lobes with tangents change; at 0 as elsewhere.
TEST(Derivative, ByTheRotationIsTheSlopeOfAllLobes) {
  const auto pairs = some_hard_pairs<double>(11, 500, 0.05);
  for (const double degrees : {0.0, 33.0, -120.0}) {
    MaterialSpec spec{{},
                      LobeSpec{"lambertian", {}},
                      {LobeSpec{"ggx", {{"alpha_x", number(0.2)}, {"alpha_y", number(0.5)}}},
                       LobeSpec{"ward", {{"alpha_x", number(0.6)}, {"alpha_y", number(0.4)}}}},
                      degrees};
    const auto slope = library_derivative(spec, "rotation", pairs, best_isa());
    constexpr double kStep = 1e-4;
    spec.rotation = degrees + kStep;
    const auto above = library_values<double>(material_of(spec), pairs, best_isa());
    spec.rotation = degrees - kStep;
    const auto below = library_values<double>(material_of(spec), pairs, best_isa());
    for (std::size_t i = 0; i < slope.size(); ++i)
      EXPECT_NEAR(slope[i], (above[i] - below[i]) / (2 * kStep), 1e-8 * (1 + above[i])) << degrees;
  }
  const auto isotropic = library_derivative(kSum, "rotation", pairs, best_isa());
  // Both of kSum's alphas but for alpha_y's own value: only ggx changes at all.
  EXPECT_NE(*std::ranges::max_element(isotropic), 0);
  const MaterialSpec flat{{}, kSum.diffuse, {kSum.specular[1]}};
  for (const double d : library_derivative(flat, "rotation", pairs, best_isa())) EXPECT_EQ(d, 0);
}

TEST(Derivative, NamesWhatItCanBeTakenBy) {
  for (const char* by : {"", "s", "parameters.s", "specular[2].parameters.s",
                         "specular[0].parameters.fresnel", "specular[0].parameters.s"}) {
    const auto none = MaterialDerivative::create(kSum, by);
    ASSERT_FALSE(none.ok()) << by;
    EXPECT_EQ(none.error().field, "by");
    EXPECT_THAT(none.error().allowed, HasSubstr("specular[1].parameters.s"));
  }
  const auto wrong =
      MaterialDerivative::create(alone("ggx", {{"alpha_x", number(7)}}), "parameters.f0");
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.error().field, "parameters.alpha_x");
}

TEST(Derivative, FlagsWhatCannotBeEvaluated) {
  const auto derivative = MaterialDerivative::create(alone("phong", {}), "parameters.s");
  ASSERT_TRUE(derivative.ok());
  const std::array<double, 6> wi{0, 0, 1, 0, 0, -1}, wo{0, 0.6, 0.8, 0, 0.6, 0.8};
  std::array<double, 2> values{7, 7};
  std::array<std::uint8_t, 2> flags{};
  const Batch<double, double> batch{Directions<double>::interleaved(wi.data()),
                                    Directions<double>::interleaved(wo.data()), 2,
                                    Values<double>::interleaved(values.data(), 1), flags.data()};
  EXPECT_EQ(derivative->evaluate(batch, best_isa()), flag::incident_below_horizon);
  EXPECT_NE(values[0], 0);
  EXPECT_EQ(values[1], 0);
  EXPECT_EQ(flags[1], flag::incident_below_horizon);
}

}  // namespace
}  // namespace gonio::testing
