// Lists of words as text. Thread safety: a function without state.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio {

// The words in their order with the separator between each two: "gold, silver, copper". Empty words
// count like others; of no words the text is empty. `Words`: any range of std::string,
// std::string_view or const char*.
template <class Words>
std::string joined(const Words& words, std::string_view separator = ", ") {
  std::string text;
  std::size_t count = 0;
  for (const auto& word : words) {
    if (count++ > 0) text += separator;
    text += word;
  }
  return text;
}

}  // namespace gonio
