#include "chart/table.h"

#include <algorithm>
#include <limits>
#include <map>

#include "chart/front.h"

namespace gonio::chart {

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

void add_front(Table& table, std::string_view cost, std::string_view error,
               std::string_view among) {
  // Choices that give NaN or negative values somewhere are on no front.
  constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
  const bool counted =
      std::ranges::find(table.columns, "improper", &Column::name) != table.columns.end();
  std::map<std::string, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    groups[among.empty() ? "" : table.word(i, among)].push_back(i);
  for (const auto& [name, rows] : groups) {
    std::vector<Tradeoff> choices;
    for (const std::size_t i : rows) {
      const bool improper = counted && table.number(i, "improper") > 0;
      choices.push_back({table.number(i, cost), improper ? kNever : table.number(i, error)});
    }
    const auto front = on_front(choices);
    for (std::size_t k = 0; k < rows.size(); ++k)
      table.rows[rows[k]].emplace_back(front[k] ? 1.0 : 0.0);
  }
  table.columns.push_back({"front", "1",
                           "1: no other choice is as good in " + std::string(cost) + " and " +
                               std::string(error) + ", and better in one"});
}

}  // namespace gonio::chart
