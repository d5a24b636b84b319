// What a certificate says is so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "fit/report/albedo.h"
#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

using Numbers = std::vector<double>;

const MaterialSpec kTruth{
    {},
    LobeSpec{"lambertian", {{"rd", Numbers{0.3}}}},
    {LobeSpec{"cook_torrance",
              {{"m", Numbers{0.2}}, {"eta", Numbers{1.6}}, {"fresnel", "dielectric"}}}}};
const std::map<std::string, double> kValues{{"diffuse.parameters.rd", 0.3},
                                            {"specular[0].parameters.m", 0.2},
                                            {"specular[0].parameters.eta", 1.6},
                                            {"specular[0].parameters.scale", 1}};

// 95 % intervals cover the truth about as often: between 90 and 98 of 100 trials.
void expect_coverage(fit::Objective objective) {
  std::map<std::string, int> covered;
  for (unsigned trial = 0; trial < 100; ++trial) {
    const auto data = data_of(kTruth, scattered_pairs(1000, trial + 1), 0.1, trial + 1000);
    fit::Options options;
    options.objective = objective;
    options.scan_pairs = 500;
    options.starts = 1;
    const auto result = fit::fit(data, form_of(kTruth), options);
    ASSERT_TRUE(result.ok());
    for (const fit::ParameterReport& p : result->certificate.parameters) {
      const double truth = kValues.at(p.field);
      covered[p.field] += p.lower <= truth && truth <= p.upper ? 1 : 0;
    }
  }
  ASSERT_EQ(covered.size(), kValues.size());
  for (const auto& [field, count] : covered) {
    EXPECT_GE(count, 90) << field;
    EXPECT_LE(count, 98) << field;
  }
}

TEST(Certificate, IntervalsOfL1CoverTheTruth) { expect_coverage(fit::Objective::l1); }
TEST(Certificate, IntervalsOfL2CoverTheTruth) { expect_coverage(fit::Objective::l2); }

TEST(Certificate, AlbedoIsThatOfTheMaterial) {
  const auto lambertian =
      Material::create({LobeSpec{"lambertian", {{"rd", Numbers{0.6}}}}, {}, {}});
  for (const double theta : {0.0, 0.7, 1.5})
    EXPECT_NEAR(fit::directional_albedo(*lambertian, theta)[0], 0.6, 2e-3);
  // A sharp lobe with F = 1 loses next to nothing at normal incidence.
  for (const double m : {0.003, 0.03, 0.1}) {
    const auto lobe = Material::create({LobeSpec{"cook_torrance", {{"m", Numbers{m}}}}, {}, {}});
    EXPECT_NEAR(fit::directional_albedo(*lobe, 0)[0], 1, 5e-3) << m;
  }
}

TEST(Certificate, ReportsWhatHoldsTheOptimum) {
  MaterialSpec truth = kTruth;
  truth.specular = {
      LobeSpec{"phong_mix", {{"s", Numbers{30}}, {"mix", Numbers{1}}, {"fresnel", "none"}}}};
  const auto result = fit::fit(data_of(truth, scattered_pairs(2000, 1), 0.1), form_of(truth), {});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->certificate.verdict, fit::Verdict::bound_limited) << result->certificate.reason;
  EXPECT_THAT(result->certificate.active_bounds,
              ::testing::Contains("specular[0].parameters.mix (upper)"));
}

TEST(Certificate, SaysWhatTheDataCannotTellApart) {
  // At one angle of incidence near the normal Fresnel's term is one number, and so is the scale.
  Pairs at;
  for (int i = 1; i < 400; ++i) {
    const double theta = 0.002 * i;
    at.wi.insert(at.wi.end(), {0, 0, 1});
    at.wo.insert(at.wo.end(), {std::sin(theta), 0, std::cos(theta)});
    at.weights.push_back(1);
  }
  const auto result = fit::fit(data_of(kTruth, at, 0.02), form_of(kTruth), {});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->certificate.verdict, fit::Verdict::ambiguous);
  EXPECT_THAT(result->certificate.reason, ::testing::HasSubstr("eta"));
}

// Nor is a colour that ends within rounding of its bound known exactly.
TEST(Certificate, ErrorsOfNothingAreAtABound) {
  MaterialSpec no_base = kTruth, no_lobe = kTruth;
  no_base.diffuse->parameters["rd"] = Numbers{0};
  no_lobe.specular[0].parameters["scale"] = Numbers{0};
  for (const auto& [truth, field] : {std::pair(no_base, "diffuse.parameters.rd"),
                                     std::pair(no_lobe, "specular[0].parameters.scale")}) {
    const auto result = fit::fit(data_of(truth, scattered_pairs(2000, 1)), form_of(truth), {});
    ASSERT_TRUE(result.ok());
    const auto& all = result->certificate.parameters;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.field == field; });
    ASSERT_NE(found, all.end());
    EXPECT_LT(found->value, 1e-6);
    EXPECT_TRUE(found->at_bound || found->standard_error > 1e-10)
        << field << " " << found->value << " +- " << found->standard_error;
  }
}

// An isotropic material's two roughnesses are one parameter: that they are equal is no doubt.
TEST(Certificate, WhatIsHeldEqualIsNotAmbiguous) {
  const LobeSpec ggx{"ggx",
                     {{"alpha_x", Numbers{0.2}}, {"alpha_y", Numbers{0.2}}, {"fresnel", "none"}}};
  const LobeSpec ward{"ward",
                      {{"rs", Numbers{0.4}}, {"alpha_x", Numbers{0.2}}, {"alpha_y", Numbers{0.2}}}};
  const LobeSpec ashikhmin{"ashikhmin_shirley", {{"nu", Numbers{50}}, {"nv", Numbers{50}}}};
  for (const LobeSpec& lobe : {ggx, ward, ashikhmin}) {
    MaterialSpec truth = kTruth;
    truth.specular = {lobe};
    const auto result =
        fit::fit(data_of(truth, scattered_pairs(2000, 1), 0.02), form_of(truth), {});
    ASSERT_TRUE(result.ok());
    for (const fit::Indistinct& i : result->certificate.indistinct) {
      EXPECT_THAT(i.fields, ::testing::Not(::testing::Contains(::testing::EndsWith("alpha_y"))));
      EXPECT_THAT(i.fields, ::testing::Not(::testing::Contains(::testing::EndsWith("nv"))));
    }
    EXPECT_NE(result->certificate.verdict, fit::Verdict::ambiguous)
        << lobe.model << ": " << result->certificate.reason;
  }
}

TEST(Certificate, WhatAFormHoldsIsNoResult) {
  const MaterialSpec truth{
      {},
      LobeSpec{"lambertian", {{"rd", Numbers{0.3}}}},
      {LobeSpec{"ashikhmin_shirley", {{"rd", Numbers{0}}, {"rs", Numbers{0.3}}}}}};
  const auto result = fit::fit(data_of(truth, scattered_pairs(300, 1)), form_of(truth), {});
  ASSERT_TRUE(result.ok());
  for (const fit::ParameterReport& p : result->certificate.parameters)
    EXPECT_NE(p.field, "specular[0].parameters.rd");
  EXPECT_EQ(std::get<Numbers>(result->material.specular[0].parameters.at("rd")), Numbers{0});
}

// The order of two lobes of one kind is no other optimum.
TEST(Certificate, LobesThatChangePlacesAreNotAmbiguous) {
  const auto ggx = [](double alpha, double scale) {
    return LobeSpec{"ggx",
                    {{"alpha_x", Numbers{alpha}},
                     {"alpha_y", Numbers{alpha}},
                     {"scale", Numbers{scale}},
                     {"fresnel", "none"}}};
  };
  MaterialSpec truth = kTruth;
  truth.specular = {ggx(0.05, 0.2), ggx(0.4, 0.2)};
  const fit::Data data = data_of(truth, scattered_pairs(3000, 1), 0.02);
  for (const bool turned : {false, true}) {
    MaterialSpec guess = truth;
    if (turned) std::swap(guess.specular[0], guess.specular[1]);
    const auto result = fit::fit(data, guess, {});
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(result->certificate.verdict, fit::Verdict::converged) << result->certificate.reason;
  }
}

}  // namespace
}  // namespace gonio::testing
