// Numbers as text, quickly and exactly. Thread safety: no state.
#pragma once

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

namespace gonio::cli {

// All of `text` as a number (also nan, inf, a leading '+'); none if it is not one. What is too
// large becomes infinite, what is too small zero or the nearest subnormal.
template <class T>
std::optional<T> parse_number(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  T value{};
  const auto [at, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || at != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {  // leaves the value alone: strtod knows which end
    const std::string copy(text);
    if constexpr (sizeof(T) == sizeof(float)) return std::strtof(copy.c_str(), nullptr);
    return std::strtod(copy.c_str(), nullptr);
  }
  return value;
}

// The digits after which text and number are the same: 9 for float, 17 for double.
template <class T>
inline constexpr int kDigits = sizeof(T) == sizeof(float) ? 9 : 17;

inline constexpr std::size_t kLongestNumber = 32;

// As printf's "%.9g" or "%.17g".
template <class T>
char* put_number(char* out, T value) {
  return std::to_chars(out, out + kLongestNumber, value, std::chars_format::general, kDigits<T>)
      .ptr;
}

// The shortest text that reads back as `value`.
template <class T>
char* put_shortest(char* out, T value) {
  return std::to_chars(out, out + kLongestNumber, value).ptr;
}

template <class T>
std::string shortest(T value) {
  char text[kLongestNumber];
  return {text, put_shortest(text, value)};
}

}  // namespace gonio::cli
