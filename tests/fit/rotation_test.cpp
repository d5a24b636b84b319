// The axes of anisotropic data: found where they are turned, left alone where they are not, and
// told of where the fit could not turn its own.
#include "fit/search/rotation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fit/cases.h"
#include "fit/form.h"
#include "fit/synthetic.h"
#include "gonio/measured/table.h"
#include "measured/synthetic_merl.h"

namespace gonio::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kNoise = 0.02;

struct Model {
  const char* name;
  LobeSpec lobe;
  const char *u, *v;
};

const std::vector<Model>& models_with_tangents() {
  static const std::vector<Model> all{
      {"ggx",
       {"ggx",
        {{"alpha_x", std::vector{0.1}}, {"alpha_y", std::vector{0.35}}, {"fresnel", "none"}}},
       "alpha_x",
       "alpha_y"},
      {"ward",
       {"ward", {{"alpha_x", std::vector{0.3}}, {"alpha_y", std::vector{0.1}}}},
       "alpha_x",
       "alpha_y"},
      {"ashikhmin_shirley",
       {"ashikhmin_shirley", {{"nu", std::vector{20.}}, {"nv", std::vector{400.}}}},
       "nu",
       "nv"}};
  return all;
}

MaterialSpec over_base(const LobeSpec& lobe, std::optional<double> degrees) {
  return {{}, LobeSpec{"lambertian", {{"rd", std::vector{0.1}}}}, {lobe}, degrees};
}

fit::Options anisotropic() {
  fit::Options options;
  options.anisotropic = true;
  options.fit_pairs = 4000;
  options.scan_pairs = 1000;
  options.starts = 3;
  return options;
}

fit::FitResult fitted(const fit::Data& data, MaterialSpec form, std::optional<double> rotation,
                      const fit::Options& options) {
  form = form_of(form);
  form.rotation = rotation;
  auto result = fit::fit(data, form, options);
  EXPECT_TRUE(result.ok()) << (result ? "" : result.error().message);
  return *result;
}

double number_of(const LobeSpec& lobe, const char* name) {
  return std::get<std::vector<double>>(lobe.parameters.at(name)).front();
}

const fit::ParameterReport* rotation_in(const fit::Certificate& report) {
  const auto found = std::ranges::find(report.parameters, "rotation", &fit::ParameterReport::field);
  return found == report.parameters.end() ? nullptr : &*found;
}

class TurnedData : public ::testing::TestWithParam<std::tuple<std::size_t, double>> {};

// Within its standard error, with an L1 as good as that of the same data unturned.
TEST_P(TurnedData, IsFoundTurned) {
  const auto& [index, degrees] = GetParam();
  const Model& model = models_with_tangents()[index];
  const Pairs pairs = scattered_pairs(4000, 5);
  const MaterialSpec truth = over_base(model.lobe, degrees);
  const auto result = fitted(data_of(truth, pairs, kNoise), truth, {}, anisotropic());
  const auto plain =
      fitted(data_of(over_base(model.lobe, {}), pairs, kNoise), truth, 0, anisotropic());
  EXPECT_LT(result.certificate.errors.all.l1, 1.01 * plain.certificate.errors.all.l1);
  EXPECT_EQ(result.certificate.verdict, fit::Verdict::converged) << result.certificate.reason;
  const fit::ParameterReport* rotation = rotation_in(result.certificate);
  ASSERT_NE(rotation, nullptr);
  EXPECT_EQ(rotation->value, result.material.rotation.value_or(0));
  EXPECT_LT(rotation->standard_error, 1);
  // A quarter of a turn swaps the axes.
  const double quarters = std::nearbyint((degrees - rotation->value) / 90);
  EXPECT_NEAR(rotation->value + 90 * quarters, degrees, 4 * rotation->standard_error);
  const bool swapped = std::fmod(std::abs(quarters), 2) == 1;
  const LobeSpec& lobe = result.material.specular.front();
  EXPECT_NEAR(number_of(lobe, swapped ? model.v : model.u) / number_of(model.lobe, model.u), 1,
              0.05);
  EXPECT_NEAR(number_of(lobe, swapped ? model.u : model.v) / number_of(model.lobe, model.v), 1,
              0.05);
}

INSTANTIATE_TEST_SUITE_P(Models, TurnedData,
                         ::testing::Combine(::testing::Values(0U, 1U, 2U),
                                            ::testing::Values(0., 10., 30., 45., 80., -60.)),
                         [](const auto& of) {
                           const double degrees = std::get<1>(of.param);
                           return std::string(models_with_tangents()[std::get<0>(of.param)].name) +
                                  (degrees < 0 ? "_minus_" : "_") +
                                  std::to_string(std::lround(std::abs(degrees)));
                         });

bool was_turned(const fit::Certificate& report) {
  return std::ranges::any_of(report.stages,
                             [](const auto& s) { return s.name.ends_with("turned"); });
}

// Isotropic data: the same search and the same result as with the axes held.
TEST(RotationOfIsotropicData, IsNotLookedFor) {
  const LobeSpec lobe{
      "ggx", {{"alpha_x", std::vector{0.2}}, {"alpha_y", std::vector{0.2}}, {"fresnel", "none"}}};
  const MaterialSpec truth = over_base(lobe, {});
  const fit::Data scattered = data_of(truth, scattered_pairs(4000, 6), kNoise);
  const auto table = MeasuredTable::from_values(tabulate(glossy_example));
  ASSERT_TRUE(table.ok());
  for (const fit::Data& data : {scattered, fit::from_table(**table)}) {
    const auto free = fitted(data, truth, {}, anisotropic());
    const auto held = fitted(data, truth, 0, anisotropic());
    EXPECT_FALSE(was_turned(free.certificate));
    EXPECT_EQ(free.material.specular.front().parameters, held.material.specular.front().parameters);
    EXPECT_EQ(free.material.rotation.value_or(0), 0);
    EXPECT_EQ(rotation_in(free.certificate), nullptr) << data.size() << " pairs: not determined";
    EXPECT_THAT(held.certificate.reason, Not(HasSubstr("anisotropic")));
  }
}

TEST(Rotation, ThatIsGivenIsHeld) {
  const Model& model = models_with_tangents()[0];
  const MaterialSpec truth = over_base(model.lobe, 130);
  const fit::Data data = data_of(truth, scattered_pairs(4000, 5), kNoise);
  const auto result = fitted(data, truth, 130, anisotropic());
  EXPECT_EQ(result.material.rotation, 130);
  EXPECT_EQ(rotation_in(result.certificate), nullptr);
  EXPECT_NEAR(number_of(result.material.specular[0], "alpha_x"), 0.1, 0.005);
  EXPECT_NEAR(number_of(result.material.specular[0], "alpha_y"), 0.35, 0.01);
  MaterialSpec bad = form_of(truth);
  bad.rotation = 200;
  const auto refused = fit::fit(data, bad, anisotropic());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "rotation");
}

// The same pairs with light from the azimuth of u alone.
Pairs of_one_azimuth(const Pairs& pairs) {
  Pairs result;
  for (std::size_t i = 0; i < pairs.weights.size(); ++i) {
    const double *wi = &pairs.wi[3 * i], *wo = &pairs.wo[3 * i];
    const double sine = std::hypot(wi[0], wi[1]), c = wi[0] / sine, s = wi[1] / sine;
    result.wi.insert(result.wi.end(), {sine, 0, wi[2]});
    result.wo.insert(result.wo.end(), {c * wo[0] + s * wo[1], c * wo[1] - s * wo[0], wo[2]});
    result.weights.push_back(pairs.weights[i]);
  }
  return result;
}

TEST(Rotation, IsHintedAtByAFitThatCannotTurn) {
  fit::Options isotropic = anisotropic();
  isotropic.anisotropic = false;
  const Model& model = models_with_tangents()[0];
  for (const double degrees : {0., 40.}) {
    const fit::Data data =
        data_of(over_base(model.lobe, degrees), scattered_pairs(4000, 5), kNoise);
    const std::string along =
        degrees == 0 ? "along the axes of the data's frame" : "axes turned by about 40 degrees";
    const auto tied = fitted(data, over_base(model.lobe, {}), {}, isotropic);
    EXPECT_THAT(tied.certificate.reason, HasSubstr("the data look anisotropic, "));
    EXPECT_THAT(tied.certificate.reason, HasSubstr(along));
    if (degrees == 0) continue;
    const auto held = fitted(data, over_base(model.lobe, {}), 0, anisotropic());
    EXPECT_THAT(held.certificate.reason, HasSubstr(along));
    // By the residuals alone: more is measured along v, where the lobe is wide.
    const auto phong = fitted(data, over_base({"phong", {{"fresnel", "none"}}}, {}), {}, isotropic);
    EXPECT_THAT(phong.certificate.reason,
                HasSubstr("the data look anisotropic, with axes turned by"));
  }
}

// One azimuth of incidence: it is what differs by side of its plane that tells.
TEST(Rotation, IsFoundAndHintedAtFromOneAzimuth) {
  fit::Options isotropic = anisotropic();
  isotropic.anisotropic = false;
  const Model& model = models_with_tangents()[0];
  const fit::Data data =
      data_of(over_base(model.lobe, 40), of_one_azimuth(scattered_pairs(4000, 5)), kNoise);
  const auto tied = fitted(data, over_base(model.lobe, {}), {}, isotropic);
  EXPECT_THAT(tied.certificate.reason, HasSubstr("axes turned by about 40 degrees"));
  const auto phong = fitted(data, over_base({"phong", {{"fresnel", "none"}}}, {}), {}, isotropic);
  EXPECT_THAT(phong.certificate.reason, HasSubstr("the data look anisotropic, with turned axes"));
  const auto free = fitted(data, over_base(model.lobe, {}), {}, anisotropic());
  EXPECT_NEAR(*free.material.rotation, 40, 1);
}

// A wrong model, at any azimuths of incidence or at one alone, is no sign of anisotropy.
TEST(Rotation, IsNotHintedAtByIsotropicData) {
  fit::Options isotropic = anisotropic();
  isotropic.anisotropic = false;
  const LobeSpec metal{
      "ggx", {{"alpha_x", std::vector{0.3}}, {"alpha_y", std::vector{0.3}}, {"fresnel", "none"}}};
  const MaterialSpec truth = over_base(metal, {});
  const Pairs pairs = scattered_pairs(4000, 7);
  for (const Pairs& directions : {pairs, of_one_azimuth(pairs)}) {
    const fit::Data data = data_of(truth, directions, kNoise);
    for (const LobeSpec& lobe : {LobeSpec{"phong", {{"fresnel", "none"}}}, LobeSpec{"ward", {}}}) {
      const auto result = fitted(data, over_base(lobe, {}), {}, isotropic);
      EXPECT_THAT(result.certificate.reason, Not(HasSubstr("anisotropic"))) << lobe.model;
    }
  }
}

// Two ends that are a quarter of a turn apart are one material.
TEST(Rotation, AQuarterOnIsTheSamePlace) {
  const auto form =
      fit::make_form(form_of(over_base(models_with_tangents()[0].lobe, {})), {true, true});
  ASSERT_TRUE(form.ok());
  ASSERT_EQ(form->rotation_shape, 2U);
  const std::vector<double> here{0.1, 0.4, 44}, there{0.4, 0.1, -45};
  EXPECT_THAT(fit::near_turn(*form, here, there), ElementsAre(0.1, 0.4, 45));
  EXPECT_THAT(fit::near_turn(*form, here, here), ElementsAre(0.1, 0.4, 44));
}

}  // namespace
}  // namespace gonio::testing
