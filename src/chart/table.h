// The tables of a chart: a row for each choice, with its cost and its error. JSON, CSV and drawings
// are made from them. Thread safety: plain values.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "timing/spread.h"

namespace gonio::chart {

// A word, or a number; NaN where there is none.
using Cell = std::variant<std::string, double>;

struct Column {
  std::string name;     // "ns"
  std::string unit;     // "ns"; "" for words, "1" for pure numbers
  std::string meaning;  // "time of one evaluation, the best repetition"
};

struct Table {
  std::string name;   // "models"
  std::string title;  // one line: what is measured
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  // a cell for each column

  // The number of a column, which must exist.
  [[nodiscard]] std::size_t column(std::string_view name) const;
  [[nodiscard]] double number(std::size_t row, std::string_view column) const;
  [[nodiscard]] const std::string& word(std::size_t row, std::string_view column) const;
};

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
