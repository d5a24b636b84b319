// The fields of a line of CSV. Thread safety: no state.
#pragma once

#include <string_view>

namespace gonio::cli {

inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

// Takes the field before the first comma off `rest`.
inline std::string_view next_field(std::string_view& rest, bool& more) {
  const std::size_t comma = rest.find(',');
  more = comma != std::string_view::npos;
  const std::string_view field = rest.substr(0, comma);
  rest.remove_prefix(more ? comma + 1 : rest.size());
  return trimmed(field);
}

}  // namespace gonio::cli
