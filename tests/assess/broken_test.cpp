// An assessment finds what is broken: materials with their bounds forced off, and errors of every
// kind planted in a good one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assess/assessed.h"
#include "effort.h"

namespace gonio::testing {
namespace {

using assess::Pair;
using assess::Subject;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

MaterialSpec ggx() {
  return alone("ggx", {{"alpha_x", number(0.2)}, {"alpha_y", number(0.2)}, {"f0", number(0.9)}});
}

struct Forced {
  std::string what;
  MaterialSpec spec;
  std::string parameter;
  double value;
  std::string fails;  // one of the checks that must
};

std::vector<Forced> forced() {
  const MaterialSpec lobe = alone("cook_torrance", {{"m", number(0.3)}, {"f0", number(0.5)}});
  const MaterialSpec diffuse = alone("lambertian", {{"rd", number(0.5)}});
  return {{"no roughness at all", ggx(), "alpha_x", 0, "improper"},
          {"a roughness of NaN", ggx(), "alpha_x", std::nan(""), "improper"},
          {"an exponent below -1", alone("ashikhmin_shirley", {{"nu", number(50)}}), "nu", -3,
           "improper"},
          {"negative reflectance", lobe, "f0", -1, "improper"},
          {"a slope of 0", lobe, "m", 0, "error_reference"},
          {"a mirror that gives", lobe, "f0", 2, "energy_gain"},
          {"a white that gives", diffuse, "rd", 1.5, "energy_gain"},
          {"a negative white", diffuse, "rd", -0.5, "improper"},
          {"a light of its own", lobe, "scale", 3, "energy_gain"}};
}

TEST(Assess, CatchesBoundsForcedOff) {
  for (const Forced& f : forced()) {
    // Under sanitizers, where a report takes a second, only of what is broken.
    EXPECT_TRUE(kSlower > 1 || report_of(subject_of(material_of(f.spec))).passed) << f.what;
    const auto report = report_of(subject_of(unchecked(f.spec, f.parameter, f.value)));
    EXPECT_FALSE(report.passed) << f.what;
    EXPECT_THAT(failed(report), Contains(f.fails)) << f.what;
  }
}

TEST(Assess, CatchesABoundThatIsNotKept) {
  const auto report = report_of(subject_of(with_stated_error(ggx(), 1e-8)));
  EXPECT_THAT(failed(report), ElementsAre("error_fast", "reciprocity"));
  EXPECT_EQ(check_of(report, "error_fast").limit, 1e-8);
}

// A good material with a fault in its values; `change` may use the pair.
template <class Change>
Subject with_values(const Change& change) {
  Subject subject = subject_of(material_of(ggx()));
  const auto original = subject.evaluate;
  subject.evaluate = [=](std::span<const Pair> pairs, Precision precision) {
    auto values = original(pairs, precision);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::min(pairs[i].wi[2], pairs[i].wo[2]) > 0) values[i] = change(pairs[i], values[i]);
    }
    return values;
  };
  return subject;
}

TEST(AssessPlanted, NothingIsFoundWhereNothingIs) {
  EXPECT_THAT(failed(report_of(with_values([](const Pair&, double f) { return f; }))), IsEmpty());
}

TEST(AssessPlanted, FactorIsFound) {
  const auto report = report_of(with_values([](const Pair&, double f) { return 1.0001 * f; }));
  EXPECT_THAT(failed(report), ElementsAre("error_fast", "error_reference"));
  EXPECT_NEAR(check_of(report, "error_reference").value, 1e-4, 1e-9);
}

TEST(AssessPlanted, SwappedDirectionIsFound) {
  const auto report = report_of(with_values(
      [](const Pair& pair, double f) { return f * (1 + 1e-4 * (pair.wi[2] - pair.wo[2])); }));
  EXPECT_THAT(failed(report), ElementsAre("error_fast", "error_reference", "reciprocity"));
}

TEST(AssessPlanted, ImproperValuesAreFoundWhereTheyAre) {
  const auto nan_at_mirror = report_of(with_values([](const Pair& pair, double f) {
    const double x = pair.wi[0] + pair.wo[0], y = pair.wi[1] + pair.wo[1];
    return f * (x * x + y * y) / (x * x + y * y);
  }));
  EXPECT_THAT(failed(nan_at_mirror), ElementsAre("improper"));
  EXPECT_EQ(check_of(nan_at_mirror, "improper").where, "exact_mirror");
  EXPECT_GT(place_of(nan_at_mirror, "exact_mirror").fast.nan, 0U);
  EXPECT_EQ(place_of(nan_at_mirror, "retro").fast.nan, 0U);
  const auto negative = report_of(with_values([](const Pair&, double f) { return f - 0.1; }));
  EXPECT_GT(place_of(negative, "hemisphere").fast.negative, 0U);
  const auto infinite = report_of(
      with_values([](const Pair& pair, double f) { return pair.wi[2] < 1e-6 ? f / 0.0 : f; }));
  EXPECT_GT(place_of(infinite, "horizon").fast.infinite, 0U);
  EXPECT_EQ(place_of(infinite, "grazing").fast.infinite, 0U);
}

TEST(AssessPlanted, LightFromBelowIsFound) {
  Subject subject = subject_of(material_of(ggx()));
  const auto original = subject.evaluate;
  subject.evaluate = [=](std::span<const Pair> pairs, Precision precision) {
    auto values = original(pairs, precision);
    for (double& f : values) f = std::max(f, 1e-6);
    return values;
  };
  const auto report = report_of(subject);
  EXPECT_THAT(failed(report), Contains("stray"));
  EXPECT_GT(place_of(report, "below_horizon").fast.stray, 0U);
}

// Densities that are not those that is drawn by, in their size and in their shape.
TEST(AssessPlanted, WrongDensityIsFound) {
  Subject subject = subject_of(material_of(ggx()));
  const auto original = subject.densities;
  subject.densities = [=](std::span<const Pair> pairs) {
    auto result = original(pairs);
    for (double& pdf : result.pdf) pdf *= 1.01;
    return result;
  };
  EXPECT_THAT(failed(report_of(subject)), Contains("pdf_mass"));
  subject.densities = [=](std::span<const Pair> pairs) {
    auto result = original(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) result.pdf[i] *= 1 + 0.2 * pairs[i].wo[1];
    return result;
  };
  EXPECT_THAT(failed(report_of(subject)), Contains("distribution"));
}

TEST(AssessPlanted, WrongWeightsAreFound) {
  Subject subject = subject_of(material_of(ggx()));
  const auto original = subject.draw;
  subject.draw = [=](const auto& wi, std::size_t count, const NumberSource& numbers,
                     Precision precision) {
    auto drawn = original(wi, count, numbers, precision);
    for (double& weight : drawn.weights) weight *= 1.03;
    return drawn;
  };
  EXPECT_THAT(failed(report_of(subject)), ElementsAre("weights", "sampled_albedo"));
}

// Lost samples that are neither drawn again nor counted.
TEST(AssessPlanted, ForgottenLossIsFound) {
  Subject subject = subject_of(material_of(ggx()));
  EXPECT_TRUE(report_of(subject).passed);
  const auto original = subject.draw;
  subject.draw = [=](const auto& wi, std::size_t count, const NumberSource& numbers,
                     Precision precision) {
    auto drawn = original(wi, count, numbers, precision);
    drawn.lost = 0;
    return drawn;
  };
  EXPECT_THAT(failed(report_of(subject)), Contains("pdf_mass"));
}

}  // namespace
}  // namespace gonio::testing
