// The parts of a chart that need no measured material, at next to no effort.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "chart/cases.h"
#include "chart/chart_tables.h"
#include "chart/machine.h"

namespace gonio::testing {
namespace {

TEST(ChartOfModels, HasEveryChoiceWithinItsStatedBound) {
  const auto table = chart::chart_models(tiny());
  ASSERT_TRUE(table);
  expect_well_formed(*table);
  expect_times(*table, "ns");
  expect_front(*table, "ns", "error_worst", "model");
  const auto cases = chart::model_cases<float>();
  EXPECT_EQ(table->rows.size(), cases.size() * (2 * supported_isas().size() + 2));
  std::size_t naive_errors = 0;
  for (const auto& model : cases) {
    const Material material = *Material::create(model.spec);
    for (std::size_t i = 0; i < table->rows.size(); ++i) {
      if (table->word(i, "model") != model.name) continue;
      EXPECT_GT(table->number(i, "checked"), 100);
      const std::string& precision = table->word(i, "precision");
      const double error = table->number(i, "error_worst");
      EXPECT_LE(table->number(i, "error_999"), error);
      EXPECT_LE(table->number(i, "error_median"), table->number(i, "error_999"));
      if (precision == "fast" || precision == "reference") {
        const auto of = precision == "fast" ? Precision::fast : Precision::reference;
        EXPECT_LE(error, material.error_bound(of).relative) << model.name << " " << precision;
        EXPECT_EQ(table->number(i, "improper"), 0);
      } else if (error > 1e-4 || table->number(i, "improper") > 0) {
        ++naive_errors;
      }
    }
  }
  // What the loops as printed are charted for.
  EXPECT_GE(naive_errors, cases.size());
}

TEST(ChartOfFresnel, FindsSchlickAndConstantsOff) {
  const auto table = chart::chart_fresnel(tiny());
  ASSERT_TRUE(table);
  expect_well_formed(*table);
  expect_times(*table, "ns");
  expect_front(*table, "ns", "error_worst", "substance");
  for (const char* substance : {"glass", "gold", "chromium"}) {
    const auto error = [&](const char* form) {
      return table->number(row_with(*table, "substance", substance, "form", form), "error_worst");
    };
    EXPECT_LT(error("exact"), 3e-6) << substance;
    EXPECT_GT(error("schlick"), 0.02) << substance;
    EXPECT_GT(error("constant"), error("schlick")) << substance;
  }
}

// (1 - c)^5 is 0.25^5 at c = 0.75: by hand for glass, F0 = 0.04.
TEST(ChartOfFresnel, SchlickByAngleIsWhatItIsByHand) {
  const chart::Table table = chart::chart_fresnel_angles();
  expect_well_formed(table);
  const double degrees = 40, c = std::cos(degrees * std::numbers::pi / 180);
  const double g = std::sqrt(1.5 * 1.5 - 1 + c * c), a = (g - c) / (g + c),
               b = (c * (g + c) - 1) / (c * (g - c) + 1), exact = a * a * (1 + b * b) / 2;
  const double schlick = 0.04 + 0.96 * std::pow(1 - c, 5);
  bool found = false;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.word(i, "substance") != "glass" || table.number(i, "theta") != degrees) continue;
    EXPECT_NEAR(table.number(i, "error"), schlick / exact - 1, 2e-6);
    found = true;
  }
  EXPECT_TRUE(found);
}

TEST(ChartOfPrintedForms, FindsWhatIsKnownOfThem) {
  const auto table = chart::chart_printed(tiny());
  ASSERT_TRUE(table);
  expect_well_formed(*table);
  expect_times(*table, "ns");
  expect_front(*table, "ns", "error_worst", "what");
  const auto printed = [&](const char* what, const char* column) {
    return table->number(row_with(*table, "what", what, "form", "printed"), column);
  };
  // The integral of D cos is pi / 4 where it should be 1.
  EXPECT_NEAR(printed("Beckmann over 4 m^2", "error_worst"), 1 - 3.14159265358979 / 4, 1e-9);
  EXPECT_NEAR(printed("Blinn's norm as (s+8)/(8 pi), s = 10", "error_worst"), 0.0748, 1e-4);
  // 0.120 in the place of 0.040 at normal incidence.
  EXPECT_NEAR(printed("Fresnel's g^2 with + 1", "error_worst"), 2, 0.1);
  EXPECT_GT(printed("Phong's cosine without a clamp, s = 11", "improper"), 0);
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    if (table->word(i, "form") != "right") continue;
    EXPECT_LT(table->number(i, "error_worst"), 1e-11) << table->word(i, "what");
    EXPECT_EQ(table->number(i, "improper"), 0);
  }
}

TEST(ChartOfDirections, SharperLobesLoseMoreInFloat32) {
  const auto table = chart::chart_directions(tiny());
  ASSERT_TRUE(table);
  expect_well_formed(*table);
  expect_front(*table, "bytes", "error_999", "material");
  double before = 0;
  for (const char* material : {"alpha = 0.3", "alpha = 0.03", "alpha = 0.003"}) {
    const auto worst = [&](const char* types) {
      return table->number(row_with(*table, "material", material, "types", types), "error_worst");
    };
    EXPECT_GT(worst("float32"), before) << material;
    before = worst("float32");
    EXPECT_LT(worst("float64"), 1e-12) << material;
  }
}

TEST(ChartOfSampling, OwnStrategiesVaryLessThanTextbooks) {
  const auto table = chart::chart_sampling(tiny());
  ASSERT_TRUE(table);
  expect_well_formed(*table);
  expect_times(*table, "ns");
  expect_front(*table, "ns", "variance", "group");
  for (const auto& model : chart::model_cases<float>()) {
    for (const char* angle : {" at 30", " at 75"}) {
      const auto variance = [&](const char* strategy) {
        return table->number(row_with(*table, "group", model.name + angle, "strategy", strategy),
                             "variance");
      };
      EXPECT_LE(variance("gonio"), 1.01 * variance("textbook") + 1e-9) << model.name << angle;
      EXPECT_LE(variance("gonio"), 1.01 * variance("cosine") + 1e-9) << model.name << angle;
    }
  }
}

TEST(Chart, EndsWhenAskedAndShowsProgress) {
  chart::Options options = tiny();
  double done = 0;
  options.progress = [&done](double part) {
    EXPECT_GE(part, done);
    EXPECT_LE(part, 1);
    done = part;
  };
  EXPECT_TRUE(chart::chart_printed(options));
  EXPECT_EQ(done, 1);
  int asked = 0;
  options.progress = {};
  options.stop = [&asked] { return ++asked > 3; };
  for (const auto& make : {chart::chart_models, chart::chart_fresnel, chart::chart_printed,
                           chart::chart_sampling, chart::chart_directions}) {
    asked = 0;
    const auto table = make(options);
    ASSERT_FALSE(table);
    EXPECT_EQ(table.error().code, ErrorCode::cancelled);
    EXPECT_LT(asked, 100);
  }
}

TEST(Chart, SaysWhatItWasMeasuredOn) {
  const chart::Machine machine = chart::this_machine();
  EXPECT_FALSE(machine.processor.empty());
  EXPECT_GE(machine.cores, 1U);
  EXPECT_EQ(machine.instruction_sets.size(), supported_isas().size());
  EXPECT_THAT(machine.system, ::testing::StartsWith("Linux "));
  EXPECT_FALSE(machine.compiler.empty());
}

}  // namespace
}  // namespace gonio::testing
