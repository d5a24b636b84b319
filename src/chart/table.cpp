#include "chart/table.h"

#include <algorithm>
#include <cassert>

namespace gonio::chart {

std::size_t Table::column(std::string_view wanted) const {
  const auto found = std::ranges::find(columns, wanted, &Column::name);
  assert(found != columns.end());
  return static_cast<std::size_t>(found - columns.begin());
}

double Table::number(std::size_t row, std::string_view wanted) const {
  return std::get<double>(rows[row][column(wanted)]);
}

const std::string& Table::word(std::size_t row, std::string_view wanted) const {
  return std::get<std::string>(rows[row][column(wanted)]);
}

void add_time_columns(Table& table, const std::string& name, const std::string& unit,
                      const std::string& of_what) {
  table.columns.push_back({name, unit, of_what + ", the best repetition"});
  table.columns.push_back({name + "_lower", unit, "lower quartile of the repetitions"});
  table.columns.push_back({name + "_median", unit, "their median"});
  table.columns.push_back({name + "_upper", unit, "their upper quartile"});
  table.columns.push_back({"repetitions", "1", "how often it was measured"});
}

void add_time_cells(std::vector<Cell>& row, const timing::Spread& spread) {
  for (const double x : {spread.best, spread.lower, spread.median, spread.upper})
    row.emplace_back(x);
  row.emplace_back(static_cast<double>(spread.repetitions));
}

}  // namespace gonio::chart
