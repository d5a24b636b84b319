#include "gonio/base/shown.h"

#include <array>
#include <cstdint>
#include <cstdio>

namespace gonio {
namespace {

struct Character {
  std::uint32_t code;  // its code point, or the byte where the bytes are not UTF-8
  std::size_t length;  // in bytes; 0 where they are not UTF-8
};

// The first character of `text`, which is not empty.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {lead, 0};
  std::uint32_t code = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return {lead, 0};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  // UTF-8 allows the shortest form only, and no half of a UTF-16 pair.
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[length] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) {
    return {lead, 0};
  }
  return {code, length};
}

bool is_hidden(std::uint32_t code) {
  return code == 0xAD || code == 0x61C || code == 0x180E || (code >= 0x200B && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F) ||
         code == 0xFEFF || (code >= 0xFFF9 && code <= 0xFFFB) ||
         (code >= 0xE0000 && code <= 0xE007F);
}

std::string escape(const Character& character) {
  switch (character.code) {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      break;
  }
  std::array<char, 16> text{};
  const bool is_byte = character.length == 0 || character.code < 0x80;
  (void)std::snprintf(text.data(), text.size(), is_byte ? "\\x%02x" : "\\u{%x}", character.code);
  return text.data();
}

}  // namespace

std::string shown(std::string_view text, std::size_t longest) {
  std::string result;
  while (!text.empty()) {
    const Character character = first_character(text);
    const bool control = character.code < 0x20 || (character.code >= 0x7F && character.code < 0xA0);
    const std::size_t length = character.length > 0 ? character.length : 1;
    const std::string next = character.length == 0 || control || is_hidden(character.code)
                                 ? escape(character)
                                 : std::string(text.substr(0, length));
    if (result.size() + next.size() > longest) return result + "...";
    result += next;
    text.remove_prefix(length);
  }
  return result;
}

}  // namespace gonio
