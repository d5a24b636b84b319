// The fields of a line of CSV. Thread safety: used by one thread.
#pragma once

#include <string_view>

namespace gonio::cli {

inline constexpr std::string_view kBlanks = " \t";

inline bool is_blank(char c) { return c == ' ' || c == '\t'; }

inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// What stands between fields: this character; or, where it is ' ', any number of blanks and tabs.
using Separator = char;

class CsvFields {
 public:
  CsvFields(std::string_view line, Separator separator)
      : rest_(separator == ' ' ? trimmed(line) : line), separator_(separator) {}

  // The next field without the blanks around it; false after the last. A field may stand between
  // double quotes, which are taken off; separators between them are text, and a quote there is
  // written twice (and stays so).
  bool next(std::string_view& field) {
    if (!more_) return false;
    const std::size_t end = end_of_field(rest_);
    field = trimmed(rest_.substr(0, end));
    if (!field.empty() && field.front() == '"') {
      take_quoted(field);
    } else {
      go_on(rest_, end);
    }
    return true;
  }

  [[nodiscard]] bool at_end() const { return !more_; }
  // A field had a quote without its partner on this line, or text behind the second one.
  [[nodiscard]] bool badly_quoted() const { return badly_quoted_; }

 private:
  [[nodiscard]] std::size_t end_of_field(std::string_view text) const {
    return separator_ == ' ' ? text.find_first_of(kBlanks) : text.find(separator_);
  }

  // The rest is what follows the separator at `end` in `text`.
  void go_on(std::string_view text, std::size_t end) {
    more_ = end != std::string_view::npos;
    rest_ = more_ ? text.substr(end + 1) : std::string_view{};
    if (separator_ == ' ') rest_ = trimmed(rest_);
  }

  void take_quoted(std::string_view& field);

  std::string_view rest_;
  Separator separator_;
  bool more_ = true, badly_quoted_ = false;
};

}  // namespace gonio::cli
