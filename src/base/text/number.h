// Numbers in text. Thread safety: functions without state.
#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace gonio {

// Reads what std::from_chars does not read to the end, after its first `good` bytes: numbers out of
// range, and Fortran's exponents, 1.0D-01. T is float or double.
template <class T>
std::optional<T> parse_unusual_number(std::string_view text, std::size_t good);

// Reads all of `text` as a number. T is float, double or an integer type, for which all characters
// must be digits. A floating-point number is decimal, with an optional point, exponent (1e-3,
// 1.0D-03) and sign, also '+', or nan or inf. Returns false and keeps `value` if `text` is no
// number. A number that is too large becomes infinite, one that is too small becomes zero or the
// nearest subnormal.
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

// The same as an optional, which is slower.
template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  return read_number(text, value) ? std::optional<T>(value) : std::nullopt;
}

// An explanation to append to a message about text that is no number, where there is one: " (a
// decimal comma: write a point)"; else empty.
std::string number_hint(std::string_view text);

}  // namespace gonio
