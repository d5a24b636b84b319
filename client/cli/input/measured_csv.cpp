#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "client/cli/input/csv/csv_table.h"
#include "client/cli/input/measured_input.h"
#include "client/cli/input/place_columns.h"
#include "gonio/base/shown.h"
#include "gonio/engine/grid.h"

namespace gonio::cli {
namespace {

constexpr const char* kHeaders =
    "a header with the columns wi_x,wi_y,wi_z,wo_x,wo_y,wo_z or theta_i,phi_i,theta_o,phi_o, and "
    "f_0 to f_63 as far as there are channels";
constexpr std::size_t kMostChannels = 64;

// Where in a row's numbers each kind of them stands: a place of up to six, then the values.
constexpr std::size_t kValues = 6, kWeight = kValues + kMostChannels, kFlags = kWeight + 1;
using Numbers = std::array<double, kFlags + 1>;

// What the columns of the file hold.
struct Columns {
  std::vector<std::size_t> targets;  // by column: which of a row's numbers; kNoColumn for none
  std::size_t channels = 0;
  std::size_t flags = kNoColumn;
  bool has_weight = false, angles = false;
};

// A value's column that is not among those that are read: f_2 without f_1, f_64.
std::string stray_value(const CsvTable& table, std::size_t channels) {
  constexpr std::string_view kValue = "f_";
  for (const std::string& name : table.header().names) {
    if (name.rfind(kValue, 0) != 0) continue;
    const auto number = parse_number<double>(std::string_view(name).substr(kValue.size()));
    if (number && *number >= static_cast<double>(channels)) return shown(name, kQuotedLength);
  }
  return {};
}

// Says of a column what it holds, if the header has one of that name.
Result<bool> add(CsvTable& table, const std::string& name, std::size_t target, Columns& columns) {
  const auto column = table.column_of(name);
  if (!column) return column.error();
  if (*column == kNoColumn) return false;
  columns.targets[*column] = target;
  return true;
}

Outcome add_values(CsvTable& table, Columns& columns) {
  for (; columns.channels < kMostChannels; ++columns.channels) {
    const auto added =
        add(table, "f_" + std::to_string(columns.channels), kValues + columns.channels, columns);
    if (!added) return added.error();
    if (!*added) break;
  }
  if (columns.channels == 0) return table.header_error("the header lacks a value f_0");
  const std::string stray = stray_value(table, columns.channels);
  if (stray.empty()) return Ok{};
  return table.header_error("the header has " + stray + " beyond f_63 or after one that it lacks");
}

Result<Columns> columns_of(CsvTable& table) {
  const CsvHeader& header = table.header();
  Columns columns;
  columns.targets.assign(header.names.size(), kNoColumn);
  columns.angles = header.set == kAngleSet;
  for (std::size_t i = 0; i < header.places.size(); ++i) columns.targets[header.places[i]] = i;
  if (auto added = add_values(table, columns); !added) return added.error();
  const auto weight = add(table, "weight", kWeight, columns);
  if (!weight) return weight.error();
  columns.has_weight = *weight;
  const auto flags = add(table, "flags", kFlags, columns);
  if (!flags) return flags.error();
  const auto column = table.column_of("flags");
  if (!column) return column.error();
  columns.flags = *column;
  table.let_be_empty(columns.flags);  // nothing is wrong with such a pair
  return columns;
}

class Reader {
 public:
  Reader(CsvTable& table, const Columns& columns, bool degrees)
      : table_(table), columns_(columns), unit_(degrees ? std::numbers::pi / 180 : 1) {}

  Outcome read(MeasuredInput& input) {
    Numbers numbers{};
    for (std::string_view row;;) {
      const auto more = table_.next_row(row);
      if (!more) return more.error();
      if (!*more) return Ok{};
      if (auto read = table_.read(row, columns_.targets, numbers.data()); !read) return read;
      if (auto good = check_flags(numbers[kFlags]); !good) return good;
      push(numbers, input);
    }
  }

 private:
  Outcome check_flags(double flags) const {
    if (flags >= 0 && std::isfinite(flags) && flags == std::floor(flags)) return Ok{};
    return bad_value(table_.where(columns_.flags), std::to_string(flags),
                     "a whole number; 0 or empty for a pair without a flag");
  }

  void push(const Numbers& numbers, MeasuredInput& input) const {
    push_place(numbers, input);
    for (std::size_t c = 0; c < columns_.channels; ++c) {
      input.values.push_back(numbers[kFlags] != 0 ? std::numeric_limits<float>::quiet_NaN()
                                                  : static_cast<float>(numbers[kValues + c]));
    }
    if (columns_.has_weight) input.weights.push_back(static_cast<float>(numbers[kWeight]));
  }

  void push_place(const Numbers& numbers, MeasuredInput& input) const {
    std::array<double, 6> xyz{};
    if (columns_.angles) {
      direction_at(numbers[0] * unit_, numbers[1] * unit_, xyz.data());
      direction_at(numbers[2] * unit_, numbers[3] * unit_, &xyz[3]);
    } else {
      std::copy_n(numbers.begin(), xyz.size(), xyz.begin());
    }
    for (std::size_t i = 0; i < 3; ++i) {
      input.wi.push_back(static_cast<float>(xyz[i]));
      input.wo.push_back(static_cast<float>(xyz[3 + i]));
    }
  }

  CsvTable& table_;
  const Columns& columns_;
  double unit_;
};

}  // namespace

Result<MeasuredInput> read_measured_csv(ByteSource source, bool degrees) {
  auto table =
      CsvTable::open(std::move(source), {{kDirectionColumns, kAngleColumns}, "--data", kHeaders});
  if (!table) return table.error();
  const auto columns = columns_of(*table);
  if (!columns) return columns.error();
  MeasuredInput input;
  input.channels = static_cast<int>(columns->channels);
  if (auto read = Reader(*table, *columns, degrees).read(input); !read) return read.error();
  return input;
}

}  // namespace gonio::cli
