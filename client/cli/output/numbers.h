// Numbers as text, quickly and exactly. Thread safety: no state.
#pragma once

#include <charconv>
#include <string>

#include "base/text/number.h"

namespace gonio::cli {

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
