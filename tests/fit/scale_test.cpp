// Measurements in any unit: the same shapes, and colours in that unit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "fit/real_data.h"
#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;
using Numbers = std::vector<double>;

// No colour of it is near a bound for any factor up to 1000.
const MaterialSpec kTruth{
    {},
    {},
    {LobeSpec{"phong", {{"s", Numbers{60}}, {"scale", Numbers{0.3}}, {"fresnel", "none"}}},
     LobeSpec{"blinn_phong", {{"s", Numbers{5}}, {"scale", Numbers{0.4}}, {"fresnel", "none"}}}}};

// As measured: no model has it exactly.
const fit::Data& ordinary() {
  static const fit::Data data = data_of(kTruth, scattered_pairs(600, 1), 0.3);
  return data;
}

fit::Data times(double factor) {
  fit::Data data = ordinary();
  for (float& value : data.values) value = static_cast<float>(static_cast<double>(value) * factor);
  return data;
}

fit::FitResult fitted(const fit::Data& data, fit::Objective objective) {
  fit::Options options;
  options.objective = objective;
  auto result = fit::fit(data, form_of(kTruth), options);
  EXPECT_TRUE(result.ok()) << result.error().message;
  return *std::move(result);
}

// log(1 + f cos) is the one loss that has a unit. Data far from reflectance get one of their own
// size, so that it bends where it bends for reflectance, within a factor of a few.
double tolerance_of(fit::Objective objective) {
  return objective == fit::Objective::log ? 0.15 : 2e-3;
}

// L1's standard errors rest on the few pairs that are fitted exactly: which ones, rounding decides.
double error_tolerance_of(fit::Objective objective) {
  const bool absolute = objective == fit::Objective::l1 || objective == fit::Objective::log;
  return absolute ? 0.5 : 0.02;
}

void expect_same(const fit::FitResult& result, const fit::FitResult& reference, double factor) {
  const auto& got = result.certificate.parameters;
  const auto& expected = reference.certificate.parameters;
  const fit::Objective objective = *result.certificate.objective;
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    const bool scales = got[i].field.ends_with("scale");
    const double unit = scales ? factor : 1;
    EXPECT_NEAR(got[i].value / (unit * expected[i].value), 1, tolerance_of(objective))
        << got[i].field;
    EXPECT_NEAR(got[i].standard_error / (unit * expected[i].standard_error), 1,
                error_tolerance_of(objective))
        << got[i].field;
    EXPECT_EQ(got[i].at_bound, expected[i].at_bound) << got[i].field;
    EXPECT_EQ(got[i].undetermined, expected[i].undetermined) << got[i].field;
  }
}

class AnyUnit : public ::testing::TestWithParam<fit::Objective> {};

TEST_P(AnyUnit, GivesTheSameMaterial) {
  const fit::FitResult reference = fitted(times(1), GetParam());
  const auto& errors = reference.certificate.errors.all;
  for (const double factor : {1e-37, 1e-30, 1e-12, 1e-9, 1e-4, 3e3}) {
    const fit::FitResult result = fitted(times(factor), GetParam());
    SCOPED_TRACE(factor);
    const double tolerance = tolerance_of(GetParam());
    expect_same(result, reference, factor);
    EXPECT_EQ(result.certificate.verdict, reference.certificate.verdict)
        << result.certificate.reason;
    EXPECT_NEAR(result.certificate.errors.all.l1 / errors.l1, 1, tolerance);
    EXPECT_NEAR(result.certificate.errors.all.rmse / (factor * errors.rmse), 1, tolerance);
    EXPECT_NEAR(result.certificate.errors.all.cbrt / (std::cbrt(factor) * errors.cbrt), 1,
                tolerance);
    EXPECT_NEAR(result.certificate.worst[0].share / reference.certificate.worst[0].share, 1,
                10 * tolerance);
    EXPECT_NEAR(result.certificate.regions.mirror.fitted,
                reference.certificate.regions.mirror.fitted, tolerance);
  }
}

// By powers of 2 that leave all digits, to the last bit.
TEST_P(AnyUnit, OfAPowerOfTwoChangesNothing) {
  const double factor = 0x1p-60;
  const fit::FitResult result = fitted(times(0x1p-100), GetParam());
  const fit::FitResult reference = fitted(times(0x1p-40), GetParam());
  for (std::size_t i = 0; i < reference.certificate.parameters.size(); ++i) {
    const fit::ParameterReport& expected = reference.certificate.parameters[i];
    const fit::ParameterReport& got = result.certificate.parameters[i];
    const double unit = got.field.ends_with("scale") ? factor : 1;
    EXPECT_EQ(got.value, unit * expected.value) << got.field;
    EXPECT_EQ(got.standard_error, unit * expected.standard_error) << got.field;
  }
  EXPECT_EQ(result.certificate.reason, reference.certificate.reason);
  EXPECT_EQ(result.certificate.stages.back().objective,
            reference.certificate.stages.back().objective);
}

INSTANTIATE_TEST_SUITE_P(Objectives, AnyUnit,
                         ::testing::Values(fit::Objective::l1, fit::Objective::l2,
                                           fit::Objective::huber, fit::Objective::log,
                                           fit::Objective::cbrt),
                         [](const auto& test) { return std::string(name_of(test.param)); });

// Bounds are those of the tables, whatever the unit: light beyond all of them is said to be so.
TEST(AnyUnit, BoundsStayAsTheyAre) {
  for (const double factor : {1e12, 1e30}) {
    for (int objective = 0; objective < fit::kObjectiveCount; ++objective) {
      const auto result = fitted(times(factor), static_cast<fit::Objective>(objective));
      EXPECT_EQ(result.certificate.verdict, fit::Verdict::bound_limited)
          << result.certificate.reason;
      EXPECT_THAT(result.certificate.reason, HasSubstr("scale"));
      for (const fit::ParameterReport& p : result.certificate.parameters) {
        EXPECT_TRUE(std::isfinite(p.value) && std::isfinite(p.standard_error)) << p.field;
      }
    }
  }
}

TEST(AnyUnit, WhatFloatsHoldWithoutDigitsIsRefused) {
  const auto result = fit::fit(times(1e-42), form_of(kTruth), {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().field, "values");
  const Pairs at = scattered_pairs(3, 1);
  for (const double value : {1e-39, 1e-60}) {
    const auto data = fit::from_pairs(at.wi, at.wo, Numbers(3, value), 1, at.weights);
    ASSERT_FALSE(data.ok()) << value;
    EXPECT_EQ(data.error().field, "values");
    EXPECT_THAT(data.error().message, HasSubstr("1.18e-38"));
  }
  EXPECT_TRUE(fit::from_pairs(at.wi, at.wo, Numbers(3, 0), 1, at.weights).ok());
  EXPECT_TRUE(fit::from_pairs(at.wi, at.wo, Numbers{0, 1e-60, 1e-37}, 1, at.weights).ok());
}

TEST(AnyUnit, ErrorsOfAMaterialFollowIt) {
  const auto of = [](double scale, double factor) {
    MaterialSpec spec = kTruth;
    for (LobeSpec& lobe : spec.specular) lobe.parameters["scale"] = Numbers{scale * factor};
    return fit::compare(*Material::create(spec), times(factor)).errors.all;
  };
  const fit::Errors expected = of(0.2, 1);
  for (const double factor : {1e-35, 1e-12, 1e3}) {
    const fit::Errors got = of(0.2, factor);
    EXPECT_NEAR(got.l1 / expected.l1, 1, 1e-5);
    EXPECT_NEAR(got.rmse / (factor * expected.rmse), 1, 1e-5);
    EXPECT_NEAR(got.cbrt / (std::cbrt(factor) * expected.cbrt), 1, 1e-5);
  }
}

}  // namespace
}  // namespace gonio::testing
