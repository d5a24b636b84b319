// Data that a fit can do little with: it works, or says clearly why not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;
using Numbers = std::vector<double>;
using fit::Verdict;

const MaterialSpec kForm{
    {}, LobeSpec{"lambertian", {}}, {LobeSpec{"cook_torrance", {{"fresnel", "dielectric"}}}}};

fit::FitResult fitted(const fit::Data& data) {
  auto result = fit::fit(data, kForm, {});
  EXPECT_TRUE(result.ok()) << result.error().message;
  EXPECT_FALSE(result->certificate.reason.empty());
  for (const fit::ParameterReport& p : result->certificate.parameters) {
    EXPECT_TRUE(std::isfinite(p.value)) << p.field;
    EXPECT_TRUE(std::isfinite(p.standard_error)) << p.field;
  }
  if (result->certificate.verdict != Verdict::failed) {
    EXPECT_TRUE(Material::create(result->material).ok());
  }
  return *std::move(result);
}

fit::Data constant(double value, std::size_t pairs = 1000) {
  const Pairs at = scattered_pairs(pairs, 1);
  return *fit::from_pairs(at.wi, at.wo, Numbers(pairs, value), 1, at.weights);
}

double diffuse_of(const fit::FitResult& result) {
  return std::get<Numbers>(result.material.diffuse->parameters.at("rd"))[0];
}

TEST(HostileData, Constant) {
  const auto result = fitted(constant(0.1));
  EXPECT_LT(result.certificate.errors.all.l1, 1e-3);
  EXPECT_NEAR(diffuse_of(result), 0.1 * std::numbers::pi, 0.05);
}

TEST(HostileData, AllZero) {
  const auto result = fitted(constant(0));
  EXPECT_EQ(result.certificate.errors.all.rmse, 0);
  EXPECT_EQ(result.certificate.verdict, Verdict::ambiguous);
  EXPECT_THAT(result.certificate.reason, HasSubstr("no height"));
}

TEST(HostileData, OneDirection) {
  const std::size_t n = 200;
  Numbers wi, wo;
  for (std::size_t i = 0; i < n; ++i) {
    wi.insert(wi.end(), {0.6, 0, 0.8});
    wo.insert(wo.end(), {-0.6, 0, 0.8});
  }
  const auto result = fitted(*fit::from_pairs(wi, wo, Numbers(n, 2.0), 1));
  EXPECT_LT(result.certificate.errors.all.l1, 1e-2);
  EXPECT_EQ(result.certificate.verdict, Verdict::ambiguous) << result.certificate.reason;
}

TEST(HostileData, FewerNumbersThanParameters) {
  const auto result = fitted(data_of({LobeSpec{"lambertian", {}}, {}, {}}, scattered_pairs(3, 1)));
  EXPECT_EQ(result.certificate.verdict, Verdict::ambiguous);
  EXPECT_THAT(result.certificate.reason, HasSubstr("3 measured numbers for 4 parameters"));
}

TEST(HostileData, LeavesOutWhatSaysNothing) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  Pairs at = scattered_pairs(1000, 1);
  Numbers values(1000, 0.1);
  values[0] = kNan;
  values[1] = kInf;
  values[2] = 1e300;  // infinite in float32
  values[3] = -1;
  at.wi[3 * 4] = kNan;
  at.wo[3 * 5 + 2] = -at.wo[3 * 5 + 2];
  at.wi[3 * 6] = 7;
  at.weights[7] = 0;
  at.weights[8] = kInf;
  const auto data = fit::from_pairs(at.wi, at.wo, values, 1, at.weights);
  ASSERT_TRUE(data.ok());
  EXPECT_EQ(data->left_out.not_finite, 5U);
  EXPECT_EQ(data->left_out.negative, 1U);
  EXPECT_EQ(data->left_out.below_horizon, 1U);
  EXPECT_EQ(data->left_out.not_unit, 1U);
  EXPECT_EQ(data->left_out.no_weight, 1U);
  EXPECT_EQ(data->size(), 991U);
  const auto result = fitted(*data);
  EXPECT_EQ(result.certificate.left_out.total(), 9U);
  EXPECT_LT(result.certificate.errors.all.l1, 1e-3);
}

TEST(HostileData, FivePairs) {
  const auto truth = MaterialSpec{LobeSpec{"lambertian", {{"rd", Numbers{0.4}}}}, {}, {}};
  const auto result = fitted(data_of(truth, scattered_pairs(5, 1)));
  EXPECT_LT(result.certificate.errors.all.l1, 1e-3);
  EXPECT_EQ(result.certificate.verdict, Verdict::ambiguous) << result.certificate.reason;
}

// Directions that the data do not see are then spread over many channels, each of which has little
// of them.
TEST(HostileData, FewPairsOfManyChannels) {
  std::vector<double> rd, f0;
  for (int c = 0; c < 31; ++c) rd.push_back(0.1 + 0.01 * c), f0.push_back(0.05 + 0.005 * c);
  const MaterialSpec truth{{},
                           LobeSpec{"lambertian", {{"rd", rd}}},
                           {LobeSpec{"ggx",
                                     {{"alpha_x", std::vector{0.3}},
                                      {"alpha_y", std::vector{0.3}},
                                      {"f0", f0},
                                      {"fresnel", "schlick"}}}}};
  const fit::Data near = fit::within(data_of(truth, scattered_pairs(20'000, 1), 0.05), 0, 0.2);
  const MaterialSpec form{
      {}, LobeSpec{"lambertian", {}}, {LobeSpec{"ggx", {{"fresnel", "conductor"}}}}};
  const auto result = fit::fit(fit::subset(near, 50, 1), form, {});
  ASSERT_TRUE(result.ok());
  const auto& found = result->certificate.indistinct;
  EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                          [](const fit::Indistinct& one) { return !one.correlation; }));
  for (const auto& direction : found) EXPECT_FALSE(direction.fields.empty());
}

TEST(HostileData, NothingLeft) {
  const auto result = fitted(constant(-1));
  EXPECT_EQ(result.certificate.verdict, Verdict::failed);
  EXPECT_THAT(result.certificate.reason, HasSubstr("1000 were left out"));
}

TEST(HostileData, NamesLengthsThatDoNotAgree) {
  const Numbers three(3, 0.5), one(1, 0.5), four(4, 0.5);
  EXPECT_EQ(fit::from_pairs(four, three, one, 1).error().field, "wi");
  EXPECT_EQ(fit::from_pairs(three, four, one, 1).error().field, "wo");
  EXPECT_EQ(fit::from_pairs(three, three, four, 1).error().field, "values");
  EXPECT_EQ(fit::from_pairs(three, three, one, 1, three).error().field, "weights");
  EXPECT_EQ(fit::from_pairs(three, three, one, 0).error().field, "channels");
  EXPECT_EQ(fit::from_pairs(three, three, one, 65).error().field, "channels");
}

// A lobe toward the light: phong's of the pair with wo turned about the normal.
TEST(HostileData, SaysThatNoLobeIsRetroreflective) {
  Pairs at = scattered_pairs(2000, 1);
  const fit::Data lobe = data_of({LobeSpec{"phong", {{"s", Numbers{50}}}}, {}, {}}, at);
  Numbers values(lobe.values.begin(), lobe.values.end());
  for (std::size_t i = 0; i < values.size(); ++i) {
    at.wo[3 * i] *= -1;
    at.wo[3 * i + 1] *= -1;
    values[i] += 0.05;
  }
  const auto result = fitted(*fit::from_pairs(at.wi, at.wo, values, 1, at.weights));
  EXPECT_EQ(result.certificate.verdict, Verdict::failed);
  EXPECT_THAT(result.certificate.reason, HasSubstr("retro-reflection"));
  const fit::Regions& regions = result.certificate.regions;
  EXPECT_GT(regions.toward_light.error, regions.mirror.error);
}

TEST(HostileData, Mirror) {
  const MaterialSpec mirror{{},
                            LobeSpec{"lambertian", {{"rd", Numbers{0.01}}}},
                            {LobeSpec{"phong", {{"s", Numbers{3e5}}}}}};
  const auto data = data_of(mirror, scattered_pairs(4000, 1));
  const auto result = fit::fit(data, form_of(mirror), {});
  ASSERT_TRUE(result.ok());
  EXPECT_LT(result->certificate.errors.all.l1, 1e-2);
  EXPECT_NE(result->certificate.verdict, Verdict::failed) << result->certificate.reason;
  const auto& lobe = result->material.specular[0].parameters;
  EXPECT_NEAR(std::get<Numbers>(lobe.at("s"))[0] / 3e5, 1, 0.01);
  EXPECT_GT(result->certificate.regions.mirror.measured, 0.9);
}

// One pair carries nearly all, beside the mirror direction: the narrowest lobe through it would
// have to be higher than the model's table allows.
TEST(HostileData, SaysThatTheMaterialWasMovedIntoItsBounds) {
  Pairs at = scattered_pairs(500, 1);
  at.wi.insert(at.wi.end(), {0.6, 0, 0.8});
  at.wo.insert(at.wo.end(), {-0.6, 0, 0.8});
  at.weights.push_back(1);
  Numbers values(500, 1e-3);
  values.push_back(3e7);
  const auto data = *fit::from_pairs(at.wi, at.wo, values, 1, at.weights);
  const auto result = fit::fit(
      data, {{}, LobeSpec{"lambertian", {}}, {LobeSpec{"phong_mix", {{"fresnel", "none"}}}}}, {});
  EXPECT_EQ(result->certificate.verdict, Verdict::bound_limited);
  EXPECT_THAT(result->certificate.reason, HasSubstr("specular[0].parameters.scale"));
}

TEST(HostileData, TwoMaterialsMixed) {
  const Pairs at = scattered_pairs(3000, 1);
  const auto narrow = data_of(
      {LobeSpec{"ggx", {{"alpha_x", Numbers{0.05}}, {"alpha_y", Numbers{0.05}}}}, {}, {}}, at);
  const auto wide = data_of({LobeSpec{"lambertian", {{"rd", Numbers{0.8}}}}, {}, {}}, at);
  Numbers values;
  for (std::size_t i = 0; i < narrow.size(); ++i)
    values.push_back(static_cast<double>(i % 2 == 0 ? narrow.values[i] : wide.values[i]));
  const auto result = fitted(*fit::from_pairs(at.wi, at.wo, values, 1, at.weights));
  EXPECT_GT(result.certificate.errors.all.l1, 0.1);  // and it says so, and where
  ASSERT_FALSE(result.certificate.worst.empty());
  EXPECT_GT(result.certificate.worst[0].share, 0);
}

}  // namespace
}  // namespace gonio::testing
