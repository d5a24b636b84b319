#include "base/text/encoding.h"

#include <string>

namespace gonio {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

bool begins(std::string_view bytes, std::string_view mark) {
  return bytes.substr(0, mark.size()) == mark;
}

// The name of the encoding that the first bytes show where it is not UTF-8, else null. What gonio
// reads begins with ASCII characters, of which UTF-16 and UTF-32 have zero bytes.
const char* other_encoding(std::string_view bytes) {
  // The longer marks come first: that of UTF-16 is the beginning of one of UTF-32.
  if (begins(bytes, "\xFF\xFE\0\0"sv) || begins(bytes, "\0\0\xFE\xFF"sv)) return "UTF-32 text";
  if (begins(bytes, "\xFF\xFE"sv) || begins(bytes, "\xFE\xFF"sv)) return "UTF-16 text";
  if (bytes.size() < kEncodingBytes) return nullptr;
  unsigned zeros = 0;  // a bit for each byte
  for (std::size_t i = 0; i < kEncodingBytes; ++i) zeros |= (bytes[i] == '\0' ? 1U : 0U) << i;
  if (zeros == 0b1110 || zeros == 0b0111) return "UTF-32 text";
  return zeros == 0b1010 || zeros == 0b0101 ? "UTF-16 text" : nullptr;
}

}  // namespace

Result<std::size_t> utf8_mark(std::string_view bytes, std::string_view name) {
  if (const char* other = other_encoding(bytes))
    return bad_value(name, other, "UTF-8: save it as UTF-8");
  return begins(bytes, kUtf8Mark) ? kUtf8Mark.size() : std::size_t{0};
}

Result<std::string_view> utf8_text(std::string_view bytes, std::string_view name) {
  const auto mark = utf8_mark(bytes, name);
  if (!mark) return mark.error();
  return bytes.substr(*mark);
}

}  // namespace gonio
