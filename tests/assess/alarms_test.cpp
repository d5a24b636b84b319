// How often assessments of good materials fail for the choice of their samples. In full:
// `assess_bench alarms`.
#include "assess/alarms.h"

#include <gtest/gtest.h>

#include "effort.h"

namespace gonio::testing {
namespace {

// Stated: one in 1000. Of these few none may.
TEST(AssessAlarms, OfModelsAreRare) {
  for (const GoodMaterial& good : good_models()) {
    const Alarms alarms = alarms_of(good.make(), kSlower > 1 ? 1 : 5);
    EXPECT_EQ(alarms.failed, 0U) << good.name << " " << alarms.least_probability << " "
                                 << alarms.largest_deviation;
  }
}

// Weights of a table have heavy tails: violet-rubber failed with the first seed by 5.2 standard
// errors.
TEST(AssessAlarms, OfTablesAreRare) {
  const auto tables = good_tables();
  if (tables.empty()) GTEST_SKIP() << "no measured materials in $GONIO_DATA";
  for (const GoodMaterial& good : tables) {
    const bool heavy = good.name == "violet-rubber";
    if (kSlower > 1 && !heavy) continue;
    const Alarms alarms = alarms_of(good.make(), heavy ? 5 : 2);
    EXPECT_EQ(alarms.failed, 0U) << good.name << " " << alarms.least_probability << " "
                                 << alarms.largest_deviation;
  }
}

}  // namespace
}  // namespace gonio::testing
