// What a verdict says in words: all numbers that it is about, and what to try.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fit/real_data.h"
#include "fit/synthetic.h"
#include "measured/pairs.h"
#include "measured/solid_angle.h"

namespace gonio::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Numbers = std::vector<double>;

MaterialSpec over_grey(LobeSpec lobe) {
  return {{}, LobeSpec{"lambertian", {{"rd", Numbers{0.1}}}}, {std::move(lobe)}};
}

// wi along the normal, wo up to 6 degrees: there Schlick's term is f0, whatever else.
Pairs about_the_normal() {
  Pairs at;
  for (int i = 1; i < 200; ++i) {
    const double theta = 0.0005 * i;
    at.wi.insert(at.wi.end(), {0, 0, 1});
    at.wo.insert(at.wo.end(), {std::sin(theta), 0, std::cos(theta)});
    at.weights.push_back(1);
  }
  return at;
}

fit::Certificate certificate_of(const fit::Data& data, const MaterialSpec& form) {
  const auto result = fit::fit(data, form, {});
  EXPECT_TRUE(result.ok()) << (result ? "" : result.error().message);
  return result->certificate;
}

// A lone name in "do not tell apart" would say nothing.
void expect_names_enough(const fit::Certificate& report) {
  if (report.reason.find("tell apart") != std::string::npos) {
    EXPECT_THAT(report.reason, HasSubstr(", ")) << report.reason;
  }
  for (const fit::Indistinct& direction : report.indistinct) {
    if (direction.correlation) {
      EXPECT_EQ(direction.fields.size(), 2U);
    }
  }
}

void expect_said(const fit::ParameterReport& p) {
  if (!p.undetermined) {
    EXPECT_LT(p.standard_error, 1e7) << p.field;
  } else {
    EXPECT_EQ(p.standard_error, 0) << p.field;
    EXPECT_LT(p.lower, p.upper) << p.field;
  }
}

TEST(Verdict, NamesWhatTheDataDoNotTellApart) {
  const MaterialSpec truth = over_grey({"ggx",
                                        {{"alpha_x", Numbers{0.02}},
                                         {"alpha_y", Numbers{0.02}},
                                         {"eta", Numbers{1.6}},
                                         {"fresnel", "dielectric"}}});
  const auto report = certificate_of(data_of(truth, about_the_normal(), 0.02), form_of(truth));
  EXPECT_EQ(report.verdict, fit::Verdict::ambiguous);
  EXPECT_THAT(report.reason, HasSubstr("specular[0].parameters.eta"));
  expect_names_enough(report);
  for (const fit::ParameterReport& p : report.parameters) expect_said(p);
}

TEST(Verdict, SaysNotDeterminedInPlaceOfAHugeStandardError) {
  for (const char* fresnel : {"none", "schlick", "dielectric", "conductor"}) {
    MaterialSpec truth = over_grey({"phong_mix", {{"s", Numbers{3000}}, {"fresnel", fresnel}}});
    for (const double noise : {0.0, 0.05}) {
      const auto report = certificate_of(data_of(truth, about_the_normal(), noise), form_of(truth));
      expect_names_enough(report);
      for (const fit::ParameterReport& p : report.parameters) expect_said(p);
    }
  }
}

TEST(Verdict, OfAMetalThatIsFittedAsADielectricHasAHint) {
  const MaterialSpec metal = over_grey(
      {"cook_torrance",
       {{"m", Numbers{0.2}}, {"eta", Numbers{2}}, {"k", Numbers{6}}, {"fresnel", "conductor"}}});
  const MaterialSpec glass = over_grey(
      {"cook_torrance", {{"m", Numbers{0.2}}, {"eta", Numbers{1.6}}, {"fresnel", "dielectric"}}});
  const Pairs at = scattered_pairs(2000, 1);
  const auto hinted = HasSubstr("try cook_torrance:conductor");
  EXPECT_THAT(certificate_of(data_of(metal, at), form_of(glass)).reason,
              AllOf(hinted, HasSubstr("specular[0].parameters.eta of ")));
  EXPECT_THAT(certificate_of(data_of(glass, at), form_of(glass)).reason, Not(hinted));
  EXPECT_THAT(certificate_of(data_of(metal, at), form_of(metal)).reason, Not(HasSubstr("try ")));
}

// A varnish whose mirror needs a higher lobe than the table's scale allows without Fresnel's help:
// the bound takes part in the search, which finds what fits inside.
TEST(Verdict, OfAMirrorHeldByItsScaleIsThatOfTheBestInside) {
  const auto pairs = read_cornell(data_folder() / "cornell" / "mystique.brdf");
  if (!pairs) GTEST_SKIP() << pairs.error().message;
  const auto data = fit::from_pairs(pairs->wi, pairs->wo, pairs->values, pairs->channels,
                                    pair_measures(pairs->wi, pairs->wo));
  const auto report = certificate_of(*data, over_lambertian("phong_mix", "dielectric"));
  EXPECT_LT(report.errors.all.l1, 0.033);
  for (const fit::ParameterReport& p : report.parameters) expect_said(p);
}

}  // namespace
}  // namespace gonio::testing
