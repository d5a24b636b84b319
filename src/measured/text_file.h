// A text file of numbers, word by word. Thread safety: used by one thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "gonio/base/result.h"

namespace gonio {

// The largest text that is read, in bytes: a hundred times what such files have.
inline constexpr std::size_t kLongestText = std::size_t{256} << 20;

// All of a file. Errors: not_found, a folder or a pipe, resource_exhausted; `expected` is what they
// say was wanted.
Result<std::string> read_text_file(const std::filesystem::path& file,
                                   const char* expected = "a text file of measurements");

class TextWords {
 public:
  // `text` must outlive the reader; `name` is what errors call it.
  TextWords(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  // The next word between blanks and comments; none at the end.
  std::optional<std::string_view> next();
  // The next word as a number. Errors: the end ("expected `what`"), what is no number.
  Result<double> number(const std::string& what);
  // True if nothing but blanks and comments is left.
  bool at_end();

  [[nodiscard]] Error error(const std::string& found, const std::string& expected) const;

 private:
  void skip_blanks();

  std::string_view rest_;
  std::string name_;
  std::size_t line_ = 1;
};

}  // namespace gonio
