#include "base/text/number.h"

#include <algorithm>
#include <cstdlib>

namespace gonio {

template <class T>
std::optional<T> parse_unusual_number(std::string_view text, std::size_t good) {
  std::string copy(text);
  if (good < text.size()) {
    if (text[good] != 'd' && text[good] != 'D') return std::nullopt;
    copy[good] = 'e';
  }
  T value{};
  const char* end = copy.data() + copy.size();
  const auto [at, error] = std::from_chars(copy.data(), end, value);
  if (at != end) return std::nullopt;
  // from_chars leaves a value that is out of range unchanged; strtod says at which end it is.
  if (error == std::errc{}) return value;
  if constexpr (sizeof(T) == sizeof(float)) return std::strtof(copy.c_str(), nullptr);
  return std::strtod(copy.c_str(), nullptr);
}

template std::optional<float> parse_unusual_number(std::string_view, std::size_t);
template std::optional<double> parse_unusual_number(std::string_view, std::size_t);

std::string number_hint(std::string_view text) {
  constexpr std::string_view kMinus = "\xE2\x88\x92";  // U+2212
  std::string other(text);
  std::replace(other.begin(), other.end(), ',', '.');
  if (other != text && parse_number<double>(other)) return " (a decimal comma: write a point)";
  other = text;
  const std::size_t minus = other.find(kMinus);
  if (minus == std::string::npos) return {};
  other.replace(minus, kMinus.size(), "-");
  return parse_number<double>(other) ? " (its minus sign is not '-')" : "";
}

}  // namespace gonio
