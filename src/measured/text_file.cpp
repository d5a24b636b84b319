#include "measured/text_file.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>

namespace gonio {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f\v";

Error file_error(ErrorCode code, const std::filesystem::path& file, const std::string& found,
                 const std::string& expected) {
  return {code, file.string() + ": found " + found + "; expected " + expected, file.string(), found,
          expected};
}

}  // namespace

Result<std::string> read_text_file(const std::filesystem::path& file, const char* expected) {
  std::error_code problem;
  const auto status = std::filesystem::status(file, problem);
  if (!std::filesystem::exists(status))
    return file_error(ErrorCode::not_found, file, "no such file", expected);
  if (!std::filesystem::is_regular_file(status))
    return file_error(ErrorCode::invalid_argument, file, "a folder, pipe or device", expected);
  const auto bytes = std::filesystem::file_size(file, problem);
  if (problem || bytes > kLongestText) {
    return file_error(ErrorCode::resource_exhausted, file, std::to_string(bytes) + " bytes",
                      "at most " + std::to_string(kLongestText));
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) return file_error(ErrorCode::not_found, file, std::strerror(errno), expected);
  std::string text(static_cast<std::size_t>(bytes), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

void TextWords::skip_blanks() {
  while (!rest_.empty()) {
    const char c = rest_.front();
    if (c == '#') {
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
    } else if (kBlanks.find(c) != std::string_view::npos) {
      line_ += c == '\n' ? 1 : 0;
      rest_.remove_prefix(1);
    } else {
      return;
    }
  }
}

bool TextWords::at_end() {
  skip_blanks();
  return rest_.empty();
}

std::optional<std::string_view> TextWords::next() {
  if (at_end()) return std::nullopt;
  const std::size_t end = std::min(rest_.find_first_of(" \t\r\n\f\v#"), rest_.size());
  const std::string_view word = rest_.substr(0, end);
  rest_.remove_prefix(end);
  return word;
}

Result<double> TextWords::number(const std::string& what) {
  const auto word = next();
  if (!word) return error("the end of the file", what);
  double value = 0;
  const auto [at, problem] = std::from_chars(word->data(), word->data() + word->size(), value);
  if (at != word->data() + word->size() || problem == std::errc::invalid_argument)
    return error("'" + std::string(word->substr(0, 100)) + "'", what);
  // Too large or too small: strtod knows which.
  if (problem != std::errc{}) return std::strtod(std::string(*word).c_str(), nullptr);
  return value;
}

Error TextWords::error(const std::string& found, const std::string& expected) const {
  return {ErrorCode::data_loss,
          name_ + ":" + std::to_string(line_) + ": found " + found + "; expected " + expected,
          name_, found, expected};
}

}  // namespace gonio
