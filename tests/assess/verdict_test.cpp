// Verdicts: every model keeps what it states, limits are the caller's, and what is not allowed.
#include "assess/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "assess/accuracy.h"
#include "assess/assessed.h"
#include "assess/places.h"
#include "effort.h"
#include "gonio/measured/table.h"
#include "models/harness/analytic_models.h"
#include "models/oracle/draws.h"

namespace gonio::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class AssessModel : public ::testing::TestWithParam<std::string> {};

// A model that is added to the registry is assessed without a line here.
TEST_P(AssessModel, Passes) {
  const auto report = report_of(subject_of(material_of(alone(GetParam(), {}))));
  EXPECT_THAT(failed(report), IsEmpty());
  EXPECT_GE(report.places.size(), 17U);
  EXPECT_GE(report.incidences.size(), 9U);
  for (const auto& place : report.places) {
    EXPECT_EQ(place.pairs, 1000U);
    EXPECT_TRUE(place.naive32 && place.naive64) << "no naive form of " << GetParam();
  }
  EXPECT_NEAR(report.incidences.back().theta, 89.9 * 3.14159265 / 180, 1e-6);
}

// At both ends of its parameters' ranges, too; what it gains is known.
TEST_P(AssessModel, KeepsItsBoundsAtTheEndsOfItsRanges) {
  const ModelDescription& model = **find_model(GetParam());
  for (const double fraction : {0.0, 1.0}) {
    const Words words = word_choices(model).front();
    const MaterialSpec spec =
        alone(GetParam(), draw_parameters(model, words, {fraction}, {fraction}));
    assess::Options options;
    options.limits.gain = std::max(0.0, model.albedo_limit - 1) + 2e-3;
    options.pairs = 500;
    EXPECT_THAT(failed(report_of(subject_of(material_of(spec)), options)), IsEmpty())
        << "at " << fraction;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, AssessModel, ::testing::ValuesIn(analytic_models()),
                         [](const auto& name) { return name.param; });

TEST(Assess, TellsWhatOrenAndNayarGain) {
  const auto report = report_of(
      subject_of(material_of(alone("oren_nayar", {{"rd", number(1)}, {"sigma", number(0.3)}}))));
  EXPECT_THAT(failed(report), ElementsAre("energy_gain"));
  EXPECT_THAT(check_of(report, "energy_gain").where, HasSubstr("89.9"));
  EXPECT_NEAR(report.incidences[7].albedo[0], 1.044, 1e-3);  // at 89 degrees
}

// A known albedo, and a known loss: AS tends to one half towards grazing, for every exponent.
TEST(Assess, FindsKnownAlbedos) {
  const auto white = report_of(subject_of(material_of(alone("lambertian", {{"rd", number(1)}}))));
  for (const auto& at : white.incidences) {
    EXPECT_NEAR(at.albedo[0], 1, 1e-6);
    EXPECT_NEAR(at.mass, 1, 1e-6);
  }
  const auto mirror = report_of(subject_of(material_of(
      alone("ashikhmin_shirley",
            {{"nu", number(1000)}, {"nv", number(1000)}, {"rs", number(1)}, {"rd", number(0)}}))));
  EXPECT_NEAR(mirror.incidences.back().albedo[0], 0.5, 0.02);
}

TEST(Assess, OfASumAndOfManyChannels) {
  MaterialSpec sum;
  sum.diffuse = LobeSpec{"lambertian", {{"rd", std::vector<double>{0.3, 0.2, 0.1}}}};
  sum.specular = {LobeSpec{"ggx", {{"alpha_x", number(0.1)}, {"alpha_y", number(0.4)}}},
                  LobeSpec{"phong", {{"s", number(50)}, {"scale", number(0.2)}}}};
  assess::Options options;
  options.limits.gain = 1;  // all three together
  const auto report = report_of(subject_of(material_of(sum)), options);
  EXPECT_THAT(failed(report), IsEmpty());
  EXPECT_EQ(report.channels, 3);
  EXPECT_EQ(report.incidences.size(), 17U);  // along v, too
  std::vector<double> spectrum(kMaxChannels);
  for (std::size_t c = 0; c < spectrum.size(); ++c) spectrum[c] = 0.01 * static_cast<double>(c);
  const auto many = report_of(subject_of(material_of(alone("cook_torrance", {{"f0", spectrum}}))));
  EXPECT_THAT(failed(many), IsEmpty());
  EXPECT_EQ(many.incidences[0].albedo.size(), 64U);
}

// A table has no naive form; its cells give what they give.
TEST(Assess, OfATable) {
  std::vector<float> cells(MeasuredTable::kCells * MeasuredTable::kChannels);
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells[i] = 0.05F + 0.05F * static_cast<float>(i / 3 / 180 % 90) / 90;
  const auto table = MeasuredTable::from_values(cells);
  ASSERT_TRUE(table.ok());
  const auto report = report_of(subject_of(Material::from_table(*table, Interpolation::linear)));
  EXPECT_THAT(failed(report), IsEmpty());
  EXPECT_FALSE(report.places[0].naive32);
}

// Pairs are drawn one after the other: of every number of them none may be read as it was not
// given.
TEST(Assess, PassesWithAnyNumberOfPairs) {
  const auto subject =
      subject_of(material_of(alone("ggx", {{"alpha_x", number(0.1)}, {"alpha_y", number(0.3)}})));
  for (const std::size_t pairs : {1, 2, 3, 5, 4001}) {
    for (std::size_t place = 0; place < assess::places().size(); ++place) {
      const auto report = assess::look_at(place, subject, pairs, 2, {});
      if (!report) continue;
      EXPECT_EQ(report->pairs, pairs);
      EXPECT_LE(report->fast.worst.error, subject.fast.relative) << report->name << " " << pairs;
    }
  }
}

TEST(Assess, LimitsAreTheCallers) {
  const auto subject = subject_of(material_of(alone("ggx", {{"f0", number(0.5)}})));
  assess::Options options;
  options.limits.error = 1e-9;
  options.limits.loss = 0.1;
  const auto report = report_of(subject, options);
  EXPECT_THAT(failed(report), ElementsAre("error_fast", "energy_loss"));
  EXPECT_EQ(check_of(report, "error_fast").limit, 1e-9);
  options.limits = {};
  options.limits.probability = 1;
  EXPECT_THAT(failed(report_of(subject, options)), ElementsAre("distribution"));
}

TEST(Assess, RefusesWhatMakesNoSense) {
  const auto field_of = [](const assess::Options& options) {
    const auto checked = assess::check_options(options);
    return checked ? std::string() : checked.error().field;
  };
  EXPECT_EQ(field_of({}), "");
  assess::Options options;
  options.limits.gain = -1;
  EXPECT_EQ(field_of(options), "limits.gain");
  options.limits = {};
  options.limits.error = std::nan("");
  EXPECT_EQ(field_of(options), "limits.error");
  options.limits = {};
  options.limits.loss = 1.5;
  EXPECT_EQ(field_of(options), "limits.loss");
  options.limits = {};
  options.pairs = 0;
  EXPECT_EQ(field_of(options), "pairs");
  options.pairs = assess::kMostPairs + 1;
  EXPECT_EQ(field_of(options), "pairs");
}

TEST(Assess, EndsSoonWhenItIsToldTo) {
  const auto subject = subject_of(material_of(alone("ggx", {})));
  assess::Options options;
  options.pairs = assess::kMostPairs / kSlower;
  for (const int after : {0, 30, 2000 / kSlower}) {
    int asked = 0;
    const auto begin = std::chrono::steady_clock::now();
    auto told = begin;
    const auto result = assess::assess(subject, options, [&] {
      if (asked++ == after) told = std::chrono::steady_clock::now();
      return asked > after;
    });
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    EXPECT_LT(std::chrono::steady_clock::now() - told, std::chrono::seconds(2));
  }
}

TEST(Assess, IsTheSameAgain) {
  const auto subject = subject_of(material_of(alone("ggx", {})));
  const auto a = report_of(subject), b = report_of(subject);
  for (std::size_t i = 0; i < a.checks.size(); ++i) EXPECT_EQ(a.checks[i].value, b.checks[i].value);
}

}  // namespace
}  // namespace gonio::testing
