// The lines of a text. A line ends in LF, CR or CR LF, and one text may have all three. Thread
// safety: find_line_end() has no state; a LineReader is used by one thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace gonio {

// The position of the first LF or CR from `from` on; npos if there is none.
std::size_t find_line_end(std::string_view text, std::size_t from = 0);

class LineReader {
 public:
  // `text` must outlive the reader.
  explicit LineReader(std::string_view text) : rest_(text) {}

  // The next line without its end; none after the last.
  std::optional<std::string_view> next();
  // The number of the line that next() gave last, from 1; after the last line, the number that
  // would follow.
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
  bool ended_ = false;
};

}  // namespace gonio
