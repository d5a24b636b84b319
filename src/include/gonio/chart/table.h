// The contents of a chart: tables of choices, a row each, with their cost and their error, and the
// machine on which they were measured. The chart, the wire (proto/wire/mapping/chart_table.h) and
// the client library use these structures. Thread safety: plain values.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gonio::chart {

struct Progress {
  std::string stage;  // "queued", or the part that is being measured
  double done = 0;    // the share of all parts that is done, 0 to 1
};

struct Machine {
  std::string processor;                      // its name in /proc/cpuinfo
  unsigned cores = 0;                         // cores that this process may run on
  std::vector<std::string> instruction_sets;  // those with kernels that it runs
  std::string gonio;                          // version
  std::string compiler;                       // "GCC 12.2.0"
  std::string system;                         // "Linux 6.1.0"
};

struct Column {
  std::string name;     // "ns"
  std::string unit;     // "ns"; "" for words, "1" for pure numbers
  std::string meaning;  // "time of one evaluation, the best repetition"
};

// A word, or a number; NaN where there is none.
using Cell = std::variant<std::string, double>;
using Row = std::vector<Cell>;

// A row is a choice. 1 in the column "front" marks choices that no other one beats.
struct Table {
  std::string name;   // "models"; of small letters, digits and '_'
  std::string title;  // one line: what is measured
  std::vector<Column> columns;
  std::vector<Row> rows;  // a cell for each column

  // The number of a column, which must exist.
  [[nodiscard]] std::size_t column(std::string_view wanted) const {
    const auto found = std::ranges::find(columns, wanted, &Column::name);
    assert(found != columns.end());
    return static_cast<std::size_t>(found - columns.begin());
  }
  [[nodiscard]] double number(std::size_t row, std::string_view wanted) const {
    return std::get<double>(rows[row][column(wanted)]);
  }
  [[nodiscard]] const std::string& word(std::size_t row, std::string_view wanted) const {
    return std::get<std::string>(rows[row][column(wanted)]);
  }
};

struct Chart {
  Machine machine;
  std::vector<Table> tables;
};

}  // namespace gonio::chart
