// Columns that the tables of a chart have in common. Thread safety: functions without state.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gonio/chart/table.h"
#include "timing/spread.h"

namespace gonio::chart {

// Columns of a measured time: "ns", its quartiles "ns_lower", "ns_median" and "ns_upper", and
// "repetitions".
void add_time_columns(Table& table, const std::string& name, const std::string& unit,
                      const std::string& of_what);
// The cells of these columns.
void add_time_cells(std::vector<Cell>& row, const timing::Spread& spread);

// A last column "front": whether a row is on the front of two columns, among the rows that have the
// same word in the column `among`; "" for all.
void add_front(Table& table, std::string_view cost, std::string_view error, std::string_view among);

}  // namespace gonio::chart
