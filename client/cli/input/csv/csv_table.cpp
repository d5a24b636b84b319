#include "client/cli/input/csv/csv_table.h"

#include <algorithm>
#include <array>

#include "base/text/encoding.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

constexpr char kComment = '#';

// Of a line that is not empty.
bool is_comment(std::string_view line) { return line[line.find_first_not_of(kBlanks)] == kComment; }

// What a comment says, without the marks before it.
std::string_view said_by(std::string_view comment) {
  comment.remove_prefix(std::min(comment.find_first_not_of("# \t"), comment.size()));
  return comment;
}

// A first line such as "sep=;", by which spreadsheets know the separator.
bool names_separator(std::string_view line) {
  return line.size() == 5 && (line.substr(0, 4) == "sep=" || line.substr(0, 4) == "SEP=");
}

}  // namespace

Result<CsvTable> CsvTable::open(ByteSource source, CsvWanted wanted) {
  CsvTable table(std::move(source), std::move(wanted));
  if (auto skipped = table.skip_mark(); !skipped) return skipped.error();
  if (auto read = table.read_header(); !read) return read.error();
  table.used_.assign(table.header_.names.size(), false);
  for (const std::size_t column : table.header_.places) table.used_[column] = true;
  return table;
}

Outcome CsvTable::skip_mark() {
  const auto start = source_.peek(kEncodingBytes);
  if (!start) return start.error();
  const auto mark = utf8_mark(*start, source_.name());
  if (!mark) return mark.error();
  std::array<char, kEncodingBytes> skipped{};
  const auto taken = source_.read(skipped.data(), *mark);
  if (!taken) return taken.error();
  return Ok{};
}

bool CsvTable::take_header(std::string_view line) {
  auto header = find_header(line, wanted_.sets);
  if (!header) return false;
  header_ = std::move(*header);
  header_text_ = line;
  header_line_ = line_number_;
  return true;
}

Outcome CsvTable::read_header() {
  bool found = false;  // in a comment
  for (std::string_view line;;) {
    const auto more = next_line(line);
    if (!more) return more.error();
    if (!*more && found) return Ok{};
    if (!*more) {
      return error(shown(source_.name()) + " is empty; allowed: " + wanted_.allowed,
                   wanted_.argument, "empty", wanted_.allowed);
    }
    if (line_number_ == 1 && names_separator(line)) continue;
    if (is_comment(line)) {
      found = take_header(said_by(line)) || found;
      continue;
    }
    if (take_header(line)) return Ok{};
    if (found) {
      pending_ = line;
      return Ok{};
    }
    header_text_ = line;
    header_line_ = line_number_;
    return header_error(header_problem(line, wanted_.sets));
  }
}

Result<std::size_t> CsvTable::column_of(std::string_view name) {
  const auto& names = header_.names;
  const auto count = std::count(names.begin(), names.end(), name);
  if (count > 1) return header_error("the header has " + std::string(name) + " twice");
  if (count == 0) return kNoColumn;
  const auto found = std::find(names.begin(), names.end(), name);
  const auto column = static_cast<std::size_t>(found - names.begin());
  used_[column] = true;
  return column;
}

Result<bool> CsvTable::next_line(std::string_view& line) {
  for (;;) {
    auto more = source_.line(line);
    if (!more || !*more) return more;
    ++line_number_;
    if (line.find_first_not_of(kBlanks) != std::string_view::npos) return true;
  }
}

Result<bool> CsvTable::next_row(std::string_view& row) {
  if (pending_) {
    row = *std::exchange(pending_, std::nullopt);
    return true;
  }
  for (;;) {
    auto more = next_line(row);
    if (!more || !*more || !is_comment(row)) return more;
    if (auto plain = check_comment(row); !plain) return plain.error();
  }
}

// In a column that nobody reads a text may begin with the mark.
Outcome CsvTable::check_comment(std::string_view line) const {
  if (used_.front()) return Ok{};
  CsvFields fields(line, header_.separator);
  std::size_t count = 0;
  for (std::string_view field; fields.next(field);) ++count;
  if (count != header_.names.size()) return Ok{};
  return error(where() +
                   ": a line that begins with '#' and has as many fields as a row; allowed: "
                   "a comment with fewer or more, or a row whose first field is quoted",
               wanted_.argument, shown(line, kQuotedLength), "a comment or a row");
}

std::string CsvTable::where() const {
  return shown(source_.name()) + ":" + std::to_string(line_number_);
}

std::string CsvTable::where(std::size_t column) const {
  return where() + ", column " + std::to_string(column + 1) + " (" +
         shown(header_.names[column], kQuotedLength) + ")";
}

Error CsvTable::error(const std::string& problem, std::string field, std::string value,
                      std::string allowed) const {
  return {ErrorCode::invalid_argument, problem, std::move(field), std::move(value),
          std::move(allowed)};
}

Error CsvTable::header_error(const std::string& problem) const {
  const std::string text = shown(header_text_, kQuotedLength);
  return error(shown(source_.name()) + ":" + std::to_string(header_line_) + ": " + problem +
                   ", found '" + text + "'; allowed: " + wanted_.allowed,
               wanted_.argument, text, wanted_.allowed);
}

Error CsvTable::not_a_number(std::size_t column, std::string_view field,
                             const CsvFields& fields) const {
  const std::string value = shown(field, kQuotedLength);
  const std::string reason =
      fields.badly_quoted() ? " (its quotes do not pair on this line)" : number_hint(field);
  return error(where(column) + ": '" + value + "' is not a number" + reason,
               shown(header_.names[column], kQuotedLength), value, "a number");
}

Outcome CsvTable::check_end(std::size_t columns, CsvFields& fields) const {
  const std::size_t named = header_.names.size();
  std::string_view last;
  bool good = columns == named || (columns + 1 == named && header_.names.back().empty());
  if (good && fields.next(last)) good = last.empty() && fields.at_end();
  if (fields.badly_quoted()) {
    return error(where() + ": quotes that do not pair on this line, or text behind them",
                 wanted_.argument, "quotes", "fields as in \"a, b\"");
  }
  if (good) return Ok{};
  const std::string most = std::to_string(named);
  if (columns < named) {
    return error(where() + ": fewer than the " + most + " columns of the header (" +
                     std::to_string(columns) + ")",
                 wanted_.argument, std::to_string(columns), most + " columns");
  }
  return error(where() + ": more than the " + most + " columns of the header", wanted_.argument,
               "more", most + " columns");
}

}  // namespace gonio::cli
