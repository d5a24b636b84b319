// What every table of a chart must be.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "chart/chart.h"
#include "chart/front.h"

namespace gonio::testing {

// Next to no repetitions: times are rough, all else is as ever.
inline chart::Options tiny() {
  chart::Options options;
  options.effort = {.repetitions = 3, .seconds = 1e-5};
  options.pairs = 40;
  return options;
}

// Rows as wide as the columns, words and numbers where they belong; times that can be; and nothing
// on the front that another row of its kind beats, nor anything off it that none beats.
inline void expect_well_formed(const chart::Table& table) {
  ASSERT_FALSE(table.rows.empty()) << table.name;
  for (const auto& row : table.rows) {
    ASSERT_EQ(row.size(), table.columns.size()) << table.name;
    for (std::size_t c = 0; c < row.size(); ++c) {
      EXPECT_EQ(std::holds_alternative<std::string>(row[c]), table.columns[c].unit.empty())
          << table.name << " " << table.columns[c].name;
      EXPECT_FALSE(table.columns[c].meaning.empty());
    }
  }
}

inline void expect_times(const chart::Table& table, const std::string& name) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    EXPECT_GT(table.number(i, name), 0);
    EXPECT_LE(table.number(i, name), table.number(i, name + "_lower"));
    EXPECT_LE(table.number(i, name + "_lower"), table.number(i, name + "_median"));
    EXPECT_LE(table.number(i, name + "_median"), table.number(i, name + "_upper"));
    EXPECT_EQ(table.number(i, "repetitions"), 3);
  }
}

inline void expect_front(const chart::Table& table, const std::string& cost,
                         const std::string& error, const std::string& among) {
  // What answers NaN or less than 0 somewhere beats nothing, however quick it is.
  const bool counted =
      std::ranges::find(table.columns, "improper", &chart::Column::name) != table.columns.end();
  const auto proper = [&](std::size_t i) { return !counted || table.number(i, "improper") == 0; };
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    bool beaten = !proper(i);
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
      if (!proper(k) || (!among.empty() && table.word(i, among) != table.word(k, among))) continue;
      const double less = table.number(i, cost) - table.number(k, cost),
                   closer = table.number(i, error) - table.number(k, error);
      beaten = beaten || (less >= 0 && closer >= 0 && (less > 0 || closer > 0));
    }
    EXPECT_EQ(table.number(i, "front"), beaten ? 0 : 1) << table.name << " row " << i;
  }
}

// The row that has these words in these columns.
inline std::size_t row_with(const chart::Table& table, const std::string& column,
                            const std::string& word, const std::string& other_column = {},
                            const std::string& other = {}) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.word(i, column) == word && (other.empty() || table.word(i, other_column) == other))
      return i;
  }
  ADD_FAILURE() << table.name << " has no " << word << " " << other;
  return 0;
}

}  // namespace gonio::testing
