// The Pareto front, and the column of a table that marks it.
#include "chart/front.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "chart/table.h"

namespace gonio::chart {
namespace {

using ::testing::ElementsAre;

TEST(Front, IsWhatNothingBeats) {
  const std::vector<Tradeoff> planted{{1, 5}, {2, 3}, {2, 4}, {3, 3}, {4, 1}, {5, 1}, {0.5, 9}};
  EXPECT_THAT(on_front(planted), ElementsAre(true, true, false, false, true, false, true));
}

TEST(Front, EqualChoicesAreBothOnIt) {
  const std::vector<Tradeoff> planted{{1, 1}, {1, 1}, {2, 1}};
  EXPECT_THAT(on_front(planted), ElementsAre(true, true, false));
}

TEST(Front, WhatIsNotKnownIsNotOnItAndBeatsNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Tradeoff> planted{{nan, 0}, {0, nan}, {1, 1}};
  EXPECT_THAT(on_front(planted), ElementsAre(false, false, true));
  EXPECT_TRUE(on_front({}).empty());
}

TEST(Front, OfManyIsTheFrontThatItsDefinitionGives) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> number(0, 40);
  std::vector<Tradeoff> choices;
  for (int i = 0; i < 300; ++i)
    choices.push_back({static_cast<double>(number(random)), static_cast<double>(number(random))});
  const auto front = on_front(choices);
  for (std::size_t i = 0; i < choices.size(); ++i) {
    bool beaten = false;
    for (const Tradeoff& other : choices) {
      const bool worse = other.cost > choices[i].cost || other.error > choices[i].error;
      const bool better = other.cost < choices[i].cost || other.error < choices[i].error;
      beaten = beaten || (better && !worse);
    }
    EXPECT_EQ(front[i], !beaten) << choices[i].cost << " " << choices[i].error;
  }
}

TEST(Front, IsMarkedAmongRowsOfOneKind) {
  Table table{"t", "", {{"kind", "", ""}, {"cost", "1", ""}, {"error", "1", ""}}, {}};
  const auto add = [&](const char* kind, double cost, double error) {
    table.rows.push_back({std::string(kind), cost, error});
  };
  add("a", 2, 2), add("b", 1, 1), add("a", 3, 1), add("a", 3, 3);
  Table all = table;
  add_front(table, "cost", "error", "kind");
  add_front(all, "cost", "error", "");
  const auto marks = [](const Table& of) {
    std::vector<double> column;
    for (std::size_t i = 0; i < of.rows.size(); ++i) column.push_back(of.number(i, "front"));
    return column;
  };
  EXPECT_THAT(marks(table), ElementsAre(1, 1, 1, 0));
  EXPECT_THAT(marks(all), ElementsAre(0, 1, 0, 0));
}

}  // namespace
}  // namespace gonio::chart
