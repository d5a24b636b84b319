#include "base/text/lines.h"

#include <emmintrin.h>

#include <bit>

namespace gonio {

// Compares sixteen bytes at a time with both characters. One search for each character would read a
// text without CR twice, and in a text without LF the whole rest for each line.
std::size_t find_line_end(std::string_view text, std::size_t from) {
  const __m128i feed = _mm_set1_epi8('\n'), carriage = _mm_set1_epi8('\r');
  std::size_t at = from;
  for (; at + 16 <= text.size(); at += 16) {
    const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(text.data() + at));
    const __m128i found =
        _mm_or_si128(_mm_cmpeq_epi8(bytes, feed), _mm_cmpeq_epi8(bytes, carriage));
    const auto mask = static_cast<unsigned>(_mm_movemask_epi8(found));
    if (mask != 0) return at + static_cast<std::size_t>(std::countr_zero(mask));
  }
  for (; at < text.size(); ++at) {
    if (text[at] == '\n' || text[at] == '\r') return at;
  }
  return std::string_view::npos;
}

std::optional<std::string_view> LineReader::next() {
  if (!ended_) ++number_;
  ended_ = rest_.empty();
  if (ended_) return std::nullopt;
  const std::size_t end = find_line_end(rest_);
  const std::string_view line = rest_.substr(0, end);
  const bool pair = end < rest_.size() && rest_.substr(end, 2) == "\r\n";
  rest_ = end < rest_.size() ? rest_.substr(end + (pair ? 2 : 1)) : std::string_view{};
  return line;
}

}  // namespace gonio
