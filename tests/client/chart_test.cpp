// Charts through the client library.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "client/support/fit_fixture.h"

namespace gonio::test {
namespace {

using Charts = ServerFixture;

client::ChartOptions quick(const std::string& part) {
  client::ChartOptions options;
  options.parts = {part};
  options.repetitions = 2;
  options.seconds = 1e-6;
  options.pairs_at_a_place = 20;
  return options;
}

TEST_F(Charts, AreTablesOfWordsAndNumbers) {
  for (const char* transport : {"tcp", "in-process"}) {
    const auto chart = connect(transport).chart(quick("directions"));
    ASSERT_TRUE(chart.ok()) << chart.error().message;
    EXPECT_FALSE(chart->machine.processor.empty());
    EXPECT_FALSE(chart->machine.instruction_sets.empty());
    ASSERT_EQ(chart->tables.size(), 1U);
    const client::ChartTable& table = chart->tables[0];
    EXPECT_EQ(table.name, "directions");
    ASSERT_FALSE(table.rows.empty());
    for (const auto& row : table.rows) {
      ASSERT_EQ(row.size(), table.columns.size());
      for (std::size_t c = 0; c < row.size(); ++c) {
        EXPECT_EQ(std::holds_alternative<std::string>(row[c]), table.columns[c].unit.empty());
      }
    }
  }
}

TEST_F(Charts, StopWhenAsked) {
  client::ChartOptions options = quick("models");
  options.repetitions = 1000;
  options.seconds = 0.1;
  client::ChartWatch watch;
  bool begun = false;
  watch.progress = [&begun](const client::ChartProgress&) { begun = true; };
  watch.stop = [&begun] { return begun; };
  const auto chart = connect("tcp").chart(options, watch);
  ASSERT_FALSE(chart.ok());
  EXPECT_EQ(chart.error().code, ErrorCode::cancelled);
}

TEST_F(Charts, SayWhatIsWrong) {
  const auto client = connect("in-process");
  const auto field = [&](const client::ChartOptions& options) {
    const auto chart = client.chart(options);
    return chart ? "nothing" : chart.error().field;
  };
  EXPECT_EQ(field(quick("everything")), "parts[0]");
  client::ChartOptions options = quick("directions");
  options.repetitions = 0;
  EXPECT_EQ(field(options), "repetitions");
  options = quick("directions");
  options.seed = 0;
  EXPECT_EQ(field(options), "seed");
  options = quick("fits");
  options.data.emplace().measured = client::Material::named("nothing");
  EXPECT_EQ(field(options), "measured.name");
}

}  // namespace
}  // namespace gonio::test
