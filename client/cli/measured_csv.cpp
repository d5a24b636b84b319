#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "client/cli/csv_fields.h"
#include "client/cli/measured_input.h"
#include "client/cli/numbers.h"
#include "gonio/engine/grid.h"

namespace gonio::cli {
namespace {

constexpr std::array<std::string_view, 6> kDirections = {"wi_x", "wi_y", "wi_z",
                                                         "wo_x", "wo_y", "wo_z"};
constexpr std::array<std::string_view, 4> kAngles = {"theta_i", "phi_i", "theta_o", "phi_o"};
constexpr const char* kHeaders =
    "a header with the columns wi_x,wi_y,wi_z,wo_x,wo_y,wo_z or theta_i,phi_i,theta_o,phi_o, and "
    "f_0 "
    "to f_63 as far as there are channels";
constexpr std::size_t kMostChannels = 64;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// The columns of the file, by what they hold.
struct Columns {
  std::vector<std::string> names;
  std::vector<std::size_t> place;   // directions or angles
  std::vector<std::size_t> values;  // f_0, f_1, ...
  std::size_t weight = kNone, flags = kNone;
  bool angles = false;
};

std::size_t column_of(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  const bool once = found != names.end() && std::find(found + 1, names.end(), name) == names.end();
  return once ? static_cast<std::size_t>(found - names.begin()) : kNone;
}

template <std::size_t N>
bool find_all(const std::array<std::string_view, N>& wanted, Columns& columns) {
  columns.place.clear();
  for (const std::string_view name : wanted)
    columns.place.push_back(column_of(columns.names, name));
  return std::find(columns.place.begin(), columns.place.end(), kNone) == columns.place.end();
}

Error header_error(const ByteSource& source, const std::string& what, std::string_view found) {
  const std::string text(found.substr(0, 100));
  return {ErrorCode::invalid_argument,
          source.name() + ":1: " + what + ", found '" + text + "'; allowed: " + kHeaders, "--data",
          text, kHeaders};
}

// A value's column that is not among those that are read: f_2 without f_1, f_1 twice, f_64.
std::string stray_value(const Columns& columns) {
  constexpr std::string_view kValue = "f_";
  for (const std::string& name : columns.names) {
    if (name.rfind(kValue, 0) != 0) continue;
    const auto number = parse_number<double>(std::string_view(name).substr(kValue.size()));
    if (number && *number >= static_cast<double>(columns.values.size())) return name;
  }
  return {};
}

Result<Columns> read_header(ByteSource& source) {
  auto line = source.line();
  if (!line) return line.error();
  if (!*line) return header_error(source, "the file is empty", "");
  std::string_view rest = **line;
  if (rest.substr(0, 3) == "\xEF\xBB\xBF") rest.remove_prefix(3);  // Excel's byte order mark
  const std::string text(rest);
  rest = text;
  Columns columns;
  for (bool more = true; more;) columns.names.emplace_back(next_field(rest, more));
  columns.angles = !find_all(kDirections, columns);
  if (columns.angles && !find_all(kAngles, columns))
    return header_error(source, "the header lacks a direction or has one twice", text);
  for (std::size_t c = 0; c < kMostChannels; ++c) {
    const std::size_t column = column_of(columns.names, "f_" + std::to_string(c));
    if (column == kNone) break;
    columns.values.push_back(column);
  }
  if (columns.values.empty())
    return header_error(source, "the header lacks a value f_0 or has it twice", text);
  if (const std::string stray = stray_value(columns); !stray.empty())
    return header_error(
        source, "the header has " + stray + " twice, beyond f_63 or after one that it lacks", text);
  columns.weight = column_of(columns.names, "weight");
  columns.flags = column_of(columns.names, "flags");
  return columns;
}

class Reader {
 public:
  Reader(ByteSource& source, const Columns& columns, bool degrees)
      : source_(source), columns_(columns), unit_(degrees ? std::numbers::pi / 180 : 1) {}

  Outcome read(MeasuredInput& input) {
    for (std::size_t number = 2;; ++number) {
      auto line = source_.line();
      if (!line) return line.error();
      if (!*line) return Ok{};
      if (trimmed(**line).empty()) continue;
      if (auto split_up = split(**line, number); !split_up) return split_up;
      if (auto read_row = row(number, input); !read_row) return read_row;
    }
  }

 private:
  Outcome split(std::string_view rest, std::size_t number) {
    fields_.clear();
    for (bool more = true; more;) fields_.push_back(next_field(rest, more));
    if (fields_.size() == columns_.names.size()) return Ok{};
    return bad_value(where(number) + ": the number of columns", std::to_string(fields_.size()),
                     std::to_string(columns_.names.size()) + ", as in the header");
  }

  Result<double> field(std::size_t column, std::size_t number) {
    const auto value = parse_number<double>(fields_[column]);
    if (value) return *value;
    return bad_value(where(number) + ", column " + std::to_string(column + 1) + " (" +
                         columns_.names[column] + ")",
                     "'" + std::string(fields_[column].substr(0, 100)) + "'", "a number");
  }

  Outcome row(std::size_t number, MeasuredInput& input) {
    std::array<double, 6> place{};
    for (std::size_t i = 0; i < columns_.place.size(); ++i) {
      const auto value = field(columns_.place[i], number);
      if (!value) return value.error();
      place[i] = *value;
    }
    push_place(place, input);
    const bool flagged = columns_.flags != kNone && fields_[columns_.flags] != "0";
    for (const std::size_t column : columns_.values) {
      const auto value = field(column, number);
      if (!value) return value.error();
      input.values.push_back(flagged ? std::numeric_limits<float>::quiet_NaN()
                                     : static_cast<float>(*value));
    }
    if (columns_.weight == kNone) return Ok{};
    const auto weight = field(columns_.weight, number);
    if (!weight) return weight.error();
    input.weights.push_back(static_cast<float>(*weight));
    return Ok{};
  }

  void push_place(const std::array<double, 6>& place, MeasuredInput& input) const {
    std::array<double, 6> xyz = place;
    if (columns_.angles) {
      direction_at(place[0] * unit_, place[1] * unit_, xyz.data());
      direction_at(place[2] * unit_, place[3] * unit_, &xyz[3]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      input.wi.push_back(static_cast<float>(xyz[i]));
      input.wo.push_back(static_cast<float>(xyz[3 + i]));
    }
  }

  [[nodiscard]] std::string where(std::size_t number) const {
    return source_.name() + ":" + std::to_string(number);
  }

  ByteSource& source_;
  const Columns& columns_;
  double unit_;
  std::vector<std::string_view> fields_;
};

}  // namespace

Result<MeasuredInput> read_measured_csv(ByteSource source, bool degrees) {
  auto columns = read_header(source);
  if (!columns) return columns.error();
  MeasuredInput input;
  input.channels = static_cast<int>(columns->values.size());
  if (auto read = Reader(source, *columns, degrees).read(input); !read) return read.error();
  return input;
}

}  // namespace gonio::cli
