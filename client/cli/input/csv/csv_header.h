// The header of a CSV file: the names of its columns, and what stands between them. Thread safety:
// functions without state.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/cli/input/csv/csv_fields.h"

namespace gonio::cli {

using NameSet = std::span<const std::string_view>;

struct CsvHeader {
  std::vector<std::string> names;  // by column, in lower case
  Separator separator = ',';
  std::size_t set = 0;              // which of the sets of names it has
  std::vector<std::size_t> places;  // the columns of that set's names
};

// A line that has all names of one of `sets`, each once, in any order, in upper or lower case,
// between commas, semicolons, tabs or blanks: whichever of these makes it a header; none if
// nothing does. The first set counts that it has.
std::optional<CsvHeader> find_header(std::string_view line, std::span<const NameSet> sets);

// What is wrong with a line that is no header: "the header lacks wo_z", "there is no header".
std::string header_problem(std::string_view line, std::span<const NameSet> sets);

}  // namespace gonio::cli
