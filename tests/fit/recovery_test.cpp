// Every model's own parameters come back from data that it made.
#include <gtest/gtest.h>

#include "effort.h"
#include "fit/cases.h"
#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

using Numbers = std::vector<double>;

class Recovery : public ::testing::TestWithParam<Case> {};

TEST_P(Recovery, OfNoiselessData) {
  const fit::Data data = data_of(GetParam().truth, scattered_pairs(kSlower > 1 ? 300 : 3000, 1));
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
  const auto result =
      fit::fit(data_of(truth, scattered_pairs(kSlower > 1 ? 200 : 1500, 1)), form_of(truth), {});
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_LT(result->certificate.errors.all.l1, 5e-4);
  const auto& fitted = result->material.specular[0].parameters;
  EXPECT_NEAR(std::get<Numbers>(fitted.at("m"))[0], 0.2, 1e-3);
  EXPECT_NEAR(std::get<Numbers>(fitted.at("eta"))[0], 1.6, 5e-3);
}

}  // namespace
}  // namespace gonio::testing
