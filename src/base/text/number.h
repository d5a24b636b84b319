// Numbers in text. Thread safety: functions without state.
#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace gonio {

// All of `text` as a number where its first `good` bytes are one as std::from_chars reads them:
// beyond the range, or with Fortran's exponent, 1.0D-01. T is float or double.
template <class T>
std::optional<T> parse_unusual_number(std::string_view text, std::size_t good);

// All of `text` as a number. T is float, double or an integer, of which all must be digits. A
// floating-point number is decimal, with a point and perhaps an exponent (1e-3, 1.0D-03); nan, inf;
// a sign, also '+'. False, and `value` as it was, if it is not one. What is too large becomes
// infinite, what is too small zero or the nearest subnormal.
template <class T>
bool read_number(std::string_view text, T& value) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  T read{};
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, read);
  if (error == std::errc{} && at == end) {
    value = read;
    return true;
  }
  if constexpr (!std::is_integral_v<T>) {
    if (error == std::errc::invalid_argument) return false;
    const auto unusual = parse_unusual_number<T>(text, static_cast<std::size_t>(at - text.data()));
    value = unusual.value_or(value);
    return unusual.has_value();
  }
  return false;
}

// The same as an optional, which takes longer.
template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  return read_number(text, value) ? std::optional<T>(value) : std::nullopt;
}

// What a message says behind text that is no number, where the reason shows: " (a decimal comma:
// write a point)"; else nothing.
std::string number_hint(std::string_view text);

}  // namespace gonio
