// Every model's own parameters come back from data that it made.
#include <gtest/gtest.h>

#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

using Numbers = std::vector<double>;

struct Case {
  std::string name;
  MaterialSpec truth;
  bool anisotropic = false;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

LobeSpec lambertian() { return {"lambertian", {{"rd", Numbers{0.3, 0.1, 0.05}}}}; }

MaterialSpec over_base(LobeSpec lobe) { return {{}, lambertian(), {std::move(lobe)}}; }

Case with_fresnel(const std::string& model, LobeSpec lobe, const std::string& fresnel) {
  if (fresnel == "none") lobe.parameters["scale"] = Numbers{0.3, 0.2, 0.1};
  if (fresnel == "schlick") {
    lobe.parameters["f0"] = Numbers{0.5, 0.3, 0.1};
    lobe.parameters["scale"] = Numbers{0.8, 0.9, 1.2};
  }
  if (fresnel == "dielectric") {
    lobe.parameters["eta"] = Numbers{1.7};
    lobe.parameters["scale"] = Numbers{2, 1, 0.5};
  }
  if (fresnel == "conductor") {
    lobe.parameters["eta"] = Numbers{0.4};
    lobe.parameters["k"] = Numbers{2.5};
  }
  lobe.parameters["fresnel"] = fresnel;
  return {model + "_" + fresnel, over_base(std::move(lobe))};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const std::vector<LobeSpec> lobes{
      {"cook_torrance", {{"m", Numbers{0.2}}}},
      {"cook_torrance", {{"s", Numbers{80}}, {"distribution", "cosine_power"}}},
      {"phong", {{"s", Numbers{40}}}},
      {"blinn_phong", {{"s", Numbers{300}}}},
      {"phong_mix", {{"s", Numbers{60}}, {"mix", Numbers{0.3}}}},
      {"ggx", {{"alpha_x", Numbers{0.15}}, {"alpha_y", Numbers{0.15}}}}};
  for (const LobeSpec& lobe : lobes) {
    const std::string name =
        lobe.model + (lobe.parameters.contains("distribution") ? "_cosine_power" : "");
    for (const char* fresnel : {"none", "schlick", "dielectric", "conductor"})
      all.push_back(with_fresnel(name, lobe, fresnel));
  }
  all.push_back({"ggx_anisotropic",
                 over_base({"ggx",
                            {{"alpha_x", Numbers{0.1}},
                             {"alpha_y", Numbers{0.4}},
                             {"f0", Numbers{0.9, 0.6, 0.3}},
                             {"fresnel", "schlick"}}}),
                 true});
  all.push_back({"ward_anisotropic",
                 over_base({"ward",
                            {{"alpha_x", Numbers{0.1}},
                             {"alpha_y", Numbers{0.3}},
                             {"rs", Numbers{0.2, 0.1, 0.3}}}}),
                 true});
  all.push_back(
      {"ward",
       over_base({"ward",
                  {{"alpha_x", Numbers{0.2}}, {"alpha_y", Numbers{0.2}}, {"rs", Numbers{0.2}}}})});
  all.push_back(
      {"ashikhmin_shirley_anisotropic",
       over_base({"ashikhmin_shirley",
                  {{"nu", Numbers{20}}, {"nv", Numbers{500}}, {"rs", Numbers{0.2, 0.3, 0.6}}}}),
       true});
  all.push_back({"ashikhmin_shirley_alone",
                 {LobeSpec{"ashikhmin_shirley",
                           {{"nu", Numbers{100}},
                            {"nv", Numbers{100}},
                            {"rd", Numbers{0.5, 0.3, 0.2}},
                            {"rs", Numbers{0.1, 0.05, 0.2}}}},
                  {},
                  {}}});
  all.push_back({"lambertian", {lambertian(), {}, {}}});
  for (const char* form : {"full", "short"}) {
    all.push_back(
        {std::string("oren_nayar_") + form,
         {LobeSpec{"oren_nayar",
                   {{"rd", Numbers{0.7, 0.4, 0.2}}, {"sigma", Numbers{0.5}}, {"form", form}}},
          {},
          {}}});
  }
  MaterialSpec two = over_base({"ggx",
                                {{"alpha_x", Numbers{0.4}},
                                 {"alpha_y", Numbers{0.4}},
                                 {"scale", Numbers{0.2}},
                                 {"fresnel", "none"}}});
  two.specular.push_back({"ggx",
                          {{"alpha_x", Numbers{0.05}},
                           {"alpha_y", Numbers{0.05}},
                           {"scale", Numbers{0.05, 0.04, 0.03}},
                           {"fresnel", "none"}}});
  all.push_back({"two_lobes", two});
  return all;
}

class Recovery : public ::testing::TestWithParam<Case> {};

TEST_P(Recovery, OfNoiselessData) {
  const fit::Data data = data_of(GetParam().truth, scattered_pairs(3000, 1));
  for (const fit::Objective objective : {fit::Objective::l1, fit::Objective::l2}) {
    fit::Options options;
    options.objective = objective;
    options.anisotropic = GetParam().anisotropic;
    const auto result = fit::fit(data, form_of(GetParam().truth), options);
    ASSERT_TRUE(result.ok()) << result.error().message;
    // L1's smoothing and the tolerances leave a part of the mean in ten thousand.
    EXPECT_LT(result->certificate.errors.all.l1, 5e-4)
        << name_of(objective) << ": " << result->certificate.reason;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Recovery, ::testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

TEST(RecoveryOfSpectra, SharesShapesAmong64Channels) {
  MaterialSpec truth = over_base(
      {"cook_torrance", {{"m", Numbers{0.2}}, {"eta", Numbers{1.6}}, {"fresnel", "dielectric"}}});
  Numbers rd, scale;
  for (int c = 0; c < 64; ++c) {
    rd.push_back(0.1 + 0.01 * c);
    scale.push_back(2 - 0.02 * c);
  }
  truth.diffuse->parameters["rd"] = rd;
  truth.specular[0].parameters["scale"] = scale;
  const auto result = fit::fit(data_of(truth, scattered_pairs(1500, 1)), form_of(truth), {});
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_LT(result->certificate.errors.all.l1, 5e-4);
  const auto& fitted = result->material.specular[0].parameters;
  EXPECT_NEAR(std::get<Numbers>(fitted.at("m"))[0], 0.2, 1e-3);
  EXPECT_NEAR(std::get<Numbers>(fitted.at("eta"))[0], 1.6, 5e-3);
}

}  // namespace
}  // namespace gonio::testing
