// Text as JSON. Thread safety: no state.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace gonio::cli {

// In quotation marks, with all that JSON does not take as it is escaped.
inline std::string json_string(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) {
      json += c;
      continue;
    }
    char escaped[8];
    std::snprintf(escaped, sizeof(escaped), "\\u%04x", static_cast<unsigned>(c));
    json += escaped;
  }
  return json + "\"";
}

}  // namespace gonio::cli
