// A CSV file with a header, as programs and people write it: behind a byte-order mark or not; with
// lines that end in LF, CR or both; with commas, semicolons, tabs or blanks between the fields,
// which may be quoted; with empty lines, and comments, which begin with '#'. As numpy.savetxt has
// it, the header may be the last comment before the rows. Thread safety: used by one thread.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/number.h"
#include "client/cli/input/byte_source.h"
#include "client/cli/input/csv/csv_fields.h"
#include "client/cli/input/csv/csv_header.h"
#include "gonio/base/result.h"

namespace gonio::cli {

inline constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);

// What a header must have, and what errors say of it.
struct CsvWanted {
  std::vector<NameSet> sets;  // of one of them all names
  const char* argument;       // that names the file: --pairs
  std::string allowed;        // what would have been a header
};

class CsvTable {
 public:
  // Errors: what has no such header, is empty, or is not UTF-8.
  static Result<CsvTable> open(ByteSource source, CsvWanted wanted);

  [[nodiscard]] const ByteSource& source() const { return source_; }
  [[nodiscard]] const CsvHeader& header() const { return header_; }
  // The column of another name, kNoColumn if there is none. Errors: two of them.
  Result<std::size_t> column_of(std::string_view name);
  // The column whose fields may be empty, which stands for 0.
  void let_be_empty(std::size_t column) { may_be_empty_ = column; }

  // The next row, valid until the next call; false at the end.
  Result<bool> next_row(std::string_view& row);
  // The numbers of a row: that of a column goes to the place of `numbers` that `targets` gives for
  // it, or nowhere (kNoColumn). Errors: what is no number, another number of fields.
  template <class Number>
  Outcome read(std::string_view row, std::span<const std::size_t> targets, Number* numbers) const {
    CsvFields fields(row, header_.separator);
    std::size_t column = 0;
    for (std::string_view field; column < targets.size() && fields.next(field); ++column) {
      if (targets[column] == kNoColumn) continue;
      Number& number = numbers[targets[column]];
      if (read_number(field, number)) continue;
      if (!field.empty() || column != may_be_empty_) return not_a_number(column, field, fields);
      number = 0;
    }
    if (column == targets.size() && fields.at_end() && !fields.badly_quoted()) return Ok{};
    return check_end(column, fields);
  }

  // "pairs.csv:17", of the row last given; with the column "pairs.csv:17, column 3 (wi_z)".
  [[nodiscard]] std::string where() const;
  [[nodiscard]] std::string where(std::size_t column) const;
  // An error of the header: "pairs.csv:1: <problem>, found '<header>'; allowed: ...".
  [[nodiscard]] Error header_error(const std::string& problem) const;

 private:
  CsvTable(ByteSource source, CsvWanted wanted)
      : source_(std::move(source)), wanted_(std::move(wanted)) {}
  Outcome skip_mark();
  Outcome read_header();
  // Takes `line` for the header if it is one.
  bool take_header(std::string_view line);
  Result<bool> next_line(std::string_view& line);  // that is not empty
  // A comment that could be a row is an error.
  Outcome check_comment(std::string_view line) const;
  [[nodiscard]] Error not_a_number(std::size_t column, std::string_view field,
                                   const CsvFields& fields) const;
  // One empty field at the end of a line counts for nothing.
  [[nodiscard]] Outcome check_end(std::size_t columns, CsvFields& fields) const;
  [[nodiscard]] Error error(const std::string& problem, std::string field, std::string value,
                            std::string allowed) const;

  ByteSource source_;
  CsvWanted wanted_;
  CsvHeader header_;
  std::string header_text_;
  std::uint64_t header_line_ = 0, line_number_ = 0;
  std::vector<bool> used_;                   // by column: somebody reads it
  std::optional<std::string_view> pending_;  // the first row, where the header was a comment
  std::size_t may_be_empty_ = kNoColumn;
};

}  // namespace gonio::cli
