// What `gonio chart` leaves in its folder.
#pragma once

#include <google/protobuf/struct.pb.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/support/run_process.h"

namespace gonio::test {

inline std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

inline std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) fields.emplace_back();
    if (c != '"' && (c != ',' || quoted)) fields.back() += c;
  }
  return fields;
}

// The same numbers and words in both files, column by column.
inline void expect_same(const google::protobuf::Struct& table, const std::string& csv) {
  const auto lines = lines_of(csv);
  const auto& columns = table.fields().at("columns").list_value();
  const auto& rows = table.fields().at("rows").list_value();
  ASSERT_EQ(lines.size(), static_cast<std::size_t>(rows.values_size()) + 1);
  const auto header = fields_of(lines[0]);
  ASSERT_EQ(header.size(), static_cast<std::size_t>(columns.values_size()));
  for (int c = 0; c < columns.values_size(); ++c) {
    const auto& column = columns.values(c).struct_value().fields();
    EXPECT_EQ(column.at("name").string_value(), header[static_cast<std::size_t>(c)]);
    EXPECT_FALSE(column.at("meaning").string_value().empty());
  }
  for (int r = 0; r < rows.values_size(); ++r) {
    const auto& row = rows.values(r).struct_value().fields();
    const auto fields = fields_of(lines[static_cast<std::size_t>(r) + 1]);
    ASSERT_EQ(fields.size(), header.size());
    for (std::size_t c = 0; c < header.size(); ++c) {
      const google::protobuf::Value& value = row.at(header[c]);
      if (value.kind_case() == google::protobuf::Value::kStringValue) {
        EXPECT_EQ(value.string_value(), fields[c]);
      } else if (value.kind_case() == google::protobuf::Value::kNumberValue) {
        EXPECT_EQ(value.number_value(), std::stod(fields[c]));
      } else {
        EXPECT_EQ(fields[c], "");
      }
    }
  }
}

// The columns of a CSV that hold no times.
inline std::vector<std::vector<std::string>> what_is_not_timed(const std::string& csv) {
  const std::vector<std::string> times{"ns",       "ns_lower",    "ns_median",
                                       "ns_upper", "fit_seconds", "front"};
  const auto lines = lines_of(csv);
  const auto header = fields_of(lines.front());
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines) {
    const auto fields = fields_of(line);
    auto& row = rows.emplace_back();
    for (std::size_t c = 0; c < header.size(); ++c) {
      if (std::ranges::find(times, header[c]) == times.end()) row.push_back(fields.at(c));
    }
  }
  return rows;
}

}  // namespace gonio::test
