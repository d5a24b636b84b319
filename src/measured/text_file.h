// A text file of numbers, row by row: a row is a line, and what is missing from one is never taken
// from the next. Comments go from '#' to the end of the line. Thread safety: used by one thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/text/lines.h"
#include "gonio/base/result.h"

namespace gonio {

// The largest text that is read, in bytes: a hundred times what such files have.
inline constexpr std::size_t kLongestText = std::size_t{256} << 20;

// All of a file. Errors: not_found, a folder or a pipe, resource_exhausted; `expected` is what they
// say was wanted.
Result<std::string> read_text_file(const std::filesystem::path& file,
                                   const char* expected = "a text file of measurements");

class TextRows {
 public:
  // `text` must outlive the reader; `name` is what errors call it.
  TextRows(std::string_view text, std::string name) : lines_(text), name_(std::move(name)) {}

  // The next number, on this line or a later one: for a file's head. Errors: the end ("expected
  // `what`"), what is no number.
  Result<double> number(const std::string& what);
  // The numbers of the next line that has any, which must be as many as `numbers` holds; false at
  // the end of the file. Errors: another number of them, what is no number, numbers that are left
  // on the line where number() ended. `what` says what a row is.
  Result<bool> row(std::span<double> numbers, const std::string& what);

  [[nodiscard]] Error error(const std::string& found, const std::string& expected) const;

 private:
  // The next word of this line; none at its end.
  std::optional<std::string_view> word();
  // Moves on to the next line with a word; false at the end of the file.
  bool next_line();
  // Takes the rest of this line.
  std::size_t count_words();
  Result<double> as_number(std::string_view word, const std::string& what) const;

  LineReader lines_;
  std::string_view line_;
  std::string name_;
};

}  // namespace gonio
