#include "base/text/lines.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace gonio {
namespace {

static_assert(std::endian::native == std::endian::little, "the first byte is the lowest");

constexpr std::uint64_t kOnes = 0x0101010101010101;

// A bit in the first byte of `eight` that is `byte`, and none before it; those behind may be wrong.
constexpr std::uint64_t marks(std::uint64_t eight, char byte) {
  const std::uint64_t same = eight ^ (kOnes * static_cast<std::uint8_t>(byte));
  return (same - kOnes) & ~same & (kOnes << 7U);
}

}  // namespace

// Eight bytes at a time: a search for each of both would read what has no CR twice, and the whole
// rest for each line of what has no LF.
std::size_t find_line_end(std::string_view text, std::size_t from) {
  std::size_t at = from;
  for (; at + 8 <= text.size(); at += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, text.data() + at, sizeof eight);
    const std::uint64_t found = marks(eight, '\n') | marks(eight, '\r');
    if (found != 0) return at + static_cast<std::size_t>(std::countr_zero(found)) / 8;
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
