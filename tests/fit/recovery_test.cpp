// Every model's own parameters come back from data that it made.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "effort.h"
#include "fit/cases.h"
#include "fit/registry_cases.h"
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

// What a material and a fit say of one parameter, channel by channel.
using Values = std::map<std::string, std::vector<double>>;

Values values_of(const fit::Form& form, MaterialSpec spec) {
  Values values;
  for (std::size_t i = 0; i < form.lobes.size(); ++i) {
    for (const auto& [name, value] : lobe_at(spec, i).parameters) {
      if (const auto* numbers = std::get_if<Numbers>(&value))
        values[form.lobes[i].prefix + "parameters." + name] = *numbers;
    }
  }
  return values;
}

// Every combination of words of every model of the registry, by its numbers: those of which the
// data say nothing are said to be undetermined.
class RegistryRecovery : public ::testing::TestWithParam<Case> {};

TEST_P(RegistryRecovery, GivesEveryNumberBack) {
  const MaterialSpec& truth = GetParam().truth;
  const fit::Data data = data_of(truth, scattered_pairs(kSlower > 1 ? 200 : 600, 1));
  fit::Options options;
  options.objective = fit::Objective::l2;
  options.anisotropic = GetParam().anisotropic;
  const auto result = fit::fit(data, form_of(truth), options);
  ASSERT_TRUE(result.ok()) << result.error().message;
  const fit::Certificate& report = result->certificate;
  EXPECT_LT(report.errors.all.l1, 5e-4) << report.reason;
  Values expected = values_of(*fit::make_form(form_of(truth), {options.anisotropic}), truth);
  std::size_t told = 0;
  for (const fit::ParameterReport& p : report.parameters) {
    const Numbers& numbers = expected[p.field];
    if (numbers.empty() || p.undetermined) continue;
    const std::size_t at =
        numbers.size() == 1 || p.channel < 0 ? 0 : static_cast<std::size_t>(p.channel);
    EXPECT_NEAR(p.value, numbers[at], 0.01 * std::max(std::abs(numbers[at]), 0.1))
        << p.field << ", channel " << p.channel << ": " << report.reason;
    ++told;
  }
  EXPECT_GE(2 * told, report.parameters.size());
}

INSTANTIATE_TEST_SUITE_P(Models, RegistryRecovery, ::testing::ValuesIn(registry_cases()),
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
