// The tables of a chart as JSON and CSV. Thread safety: functions without state.
#pragma once

#include <string>
#include <vector>

#include "chart/machine.h"
#include "chart/table.h"
#include "timing/race.h"

namespace gonio::cli {

// A chart as a whole.
struct Chart {
  chart::Machine machine;
  timing::Effort effort;
  std::string material;  // what the parts that fit were given; empty: nothing
  std::vector<chart::Table> tables;
};

// {"machine": {...}, "tables": [{"name", "title", "columns": [...], "rows": [{COLUMN: VALUE}]}]}; a
// number that there is not is null.
std::string chart_json(const Chart& chart);

// A header with the columns' names and a line a row; a number that there is not is empty.
std::string table_csv(const chart::Table& table);

}  // namespace gonio::cli
