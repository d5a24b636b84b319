// The parts of a chart about a measured material.
#include <gtest/gtest.h>

#include <cmath>

#include "chart/chart_tables.h"
#include "chart/example.h"
#include "effort.h"

namespace gonio::testing {
namespace {

// The generated material; of its cells only some, so that fits are quick.
const chart::Measured& measured() {
  static const chart::Measured found = [] {
    auto table = chart::example_table(1);
    const std::size_t pairs = kSlower > 1 ? 600 : 3000;
    return chart::Measured{"paint", fit::subset(fit::from_table(*table), pairs, 1), table};
  }();
  return found;
}

TEST(ExampleTable, IsTheSameForASeedAndHasNoise) {
  const auto a = chart::example_table(1), b = chart::example_table(1), c = chart::example_table(2);
  EXPECT_LT(a->invalid_cells(), MeasuredTable::kCells / 2);
  double most = 0;
  for (std::size_t i = 0; i < MeasuredTable::kCells * 3; i += 97) {
    if (std::isnan(a->data()[i])) continue;
    EXPECT_EQ(a->data()[i], b->data()[i]);
    if (a->data()[i] > 0) most = std::max<double>(most, std::abs(c->data()[i] / a->data()[i] - 1));
  }
  EXPECT_GT(most, 0.05);
  EXPECT_LT(most, 0.3);
}

TEST(ChartOfFits, HasTheTableAtNoErrorAndTheRightLobesBefore) {
  const auto table = chart::chart_fits(measured(), tiny());
  ASSERT_TRUE(table);
  expect_well_formed(*table);
  expect_times(*table, "ns");
  expect_front(*table, "ns", "l1_all", "");
  const auto number = [&](const char* name, const char* column) {
    return table->number(row_with(*table, "representation", name), column);
  };
  EXPECT_LT(number("table, nearest cell", "l1_all"), 1e-6);
  EXPECT_LT(number("table, interpolated", "l1_all"), 1e-3);
  EXPECT_EQ(number("table, nearest cell", "bytes"), 12.0 * MeasuredTable::kCells);
  EXPECT_EQ(number("lambertian", "bytes"), 24);
  // It was made of two lobes of ggx: one is better than any other, two are better than one.
  EXPECT_LT(number("ggx dielectric", "l1_all"), number("cook_torrance dielectric", "l1_all"));
  EXPECT_LT(number("2 x ggx schlick", "l1_all"), number("ggx schlick", "l1_all"));
  EXPECT_LT(number("2 x ggx schlick", "l1_all"), 0.2);
  EXPECT_GT(number("lambertian", "l1_all"), 0.3);
}

TEST(ChartOfFits, TakesScatteredPairsWithoutATable) {
  chart::Measured pairs = measured();
  pairs.table = nullptr;
  const auto table = chart::chart_fits(pairs, tiny());
  ASSERT_TRUE(table);
  expect_well_formed(*table);
  for (std::size_t i = 0; i < table->rows.size(); ++i)
    EXPECT_NE(table->word(i, "verdict"), "measured");
}

TEST(ChartOfResolution, FewerCellsErrMore) {
  const auto table = chart::chart_resolution(measured(), tiny());
  ASSERT_TRUE(table);
  expect_well_formed(*table);
  expect_front(*table, "bytes", "l1_all", "");
  const auto error = [&](const char* cells, const char* interpolation) {
    return table->number(row_with(*table, "cells", cells, "interpolation", interpolation),
                         "l1_all");
  };
  for (const char* interpolation : {"nearest", "linear"}) {
    EXPECT_LT(error("90 x 90 x 180", interpolation), 1e-6);
    EXPECT_LT(error("90 x 90 x 180", interpolation), error("45 x 45 x 90", interpolation));
    EXPECT_LT(error("45 x 45 x 90", interpolation), error("30 x 30 x 60", interpolation));
    EXPECT_LT(error("30 x 30 x 60", interpolation), error("15 x 15 x 30", interpolation));
  }
  // Between cells of a smooth material it is smoother than in them.
  EXPECT_LT(error("45 x 45 x 90", "linear"), error("45 x 45 x 90", "nearest"));
}

}  // namespace
}  // namespace gonio::testing
