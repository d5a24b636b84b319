#include "measured/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "base/text/number.h"
#include "gonio/base/shown.h"
#include "measured/file_error.h"

namespace gonio {
namespace {

constexpr std::string_view kBlanks = " \t\f\v";

}  // namespace

Result<std::string> read_text_file(const std::filesystem::path& file, const char* expected) {
  std::error_code problem;
  const auto status = std::filesystem::status(file, problem);
  if (!std::filesystem::exists(status))
    return file_error(ErrorCode::not_found, file.string(), "no such file", expected);
  if (!std::filesystem::is_regular_file(status))
    return file_error(ErrorCode::invalid_argument, file.string(), "a folder, pipe or device",
                      expected);
  const auto bytes = std::filesystem::file_size(file, problem);
  if (problem || bytes > kLongestText) {
    return file_error(ErrorCode::resource_exhausted, file.string(),
                      std::to_string(bytes) + " bytes", "at most " + std::to_string(kLongestText));
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) return file_error(ErrorCode::not_found, file.string(), std::strerror(errno), expected);
  std::string text(static_cast<std::size_t>(bytes), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

bool TextRows::next_line() {
  for (;;) {
    const auto line = lines_.next();
    line_ = line.value_or(std::string_view{});
    line_ = line_.substr(0, line_.find('#'));
    if (!line) return false;
    if (line_.find_first_not_of(kBlanks) != std::string_view::npos) return true;
  }
}

std::optional<std::string_view> TextRows::word() {
  line_.remove_prefix(std::min(line_.find_first_not_of(kBlanks), line_.size()));
  if (line_.empty()) return std::nullopt;
  const std::size_t end = std::min(line_.find_first_of(kBlanks), line_.size());
  const std::string_view word = line_.substr(0, end);
  line_.remove_prefix(end);
  return word;
}

std::size_t TextRows::count_words() {
  std::size_t count = 0;
  while (word()) ++count;
  return count;
}

Result<double> TextRows::as_number(std::string_view word, const std::string& what) const {
  if (const auto value = parse_number<double>(word)) return *value;
  return error("'" + shown(word, kQuotedLength) + "'" + number_hint(word), what);
}

Result<double> TextRows::number(const std::string& what) {
  auto next = word();
  while (!next) {
    if (!next_line()) return error("the end of the file", what);
    next = word();
  }
  return as_number(*next, what);
}

Result<bool> TextRows::row(std::span<double> numbers, const std::string& what) {
  if (const std::size_t left = count_words(); left > 0)
    return error(std::to_string(left) + " more on this line", "its end, and then rows of " + what);
  if (!next_line()) return false;
  std::size_t count = 0;
  for (auto next = word(); next; next = word(), ++count) {
    const auto value = as_number(*next, what);
    if (!value) return value.error();
    if (count < numbers.size()) numbers[count] = *value;
  }
  if (count == numbers.size()) return true;
  return error(std::to_string(count) + (count == 1 ? " number" : " numbers"),
               std::to_string(numbers.size()) + ": " + what);
}

Error TextRows::error(const std::string& found, const std::string& expected) const {
  return file_error(ErrorCode::data_loss, name_ + ":" + std::to_string(lines_.number()), found,
                    expected);
}

}  // namespace gonio
