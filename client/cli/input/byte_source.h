// A file or standard input, read block by block. Thread safety: used by one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/base/result.h"

namespace gonio::cli {

class ByteSource {
 public:
  // "-" is standard input. Errors: not_found, and why it cannot be read.
  static Result<ByteSource> open(const std::string& file);

  ~ByteSource();
  ByteSource(ByteSource&& other) noexcept;
  ByteSource& operator=(ByteSource&&) = delete;

  // For messages.
  [[nodiscard]] const std::string& name() const { return name_; }
  // In bytes, where that is known.
  [[nodiscard]] std::optional<std::uint64_t> size() const { return size_; }
  [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }

  // The next `count` bytes, without taking them; fewer at the end. Valid until the next call.
  Result<std::string_view> peek(std::size_t count);
  // Copies the next `count` bytes; fewer at the end.
  Result<std::size_t> read(void* to, std::size_t count);
  // The next line without its end (LF, CR or CR LF); false at the end. Valid until the next call.
  // Errors: a line beyond 1 MiB. After the first line only lines may be read.
  Result<bool> line(std::string_view& line);

 private:
  ByteSource(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) {}
  Result<bool> refill();  // false at the end
  // The next line if its end is buffered, where the first `searched` bytes have none.
  bool buffered_line(std::string_view& line, std::size_t searched);
  // Takes the line feed that belongs to the end of the line before, once it has come.
  void finish_line_end();
  [[nodiscard]] Error too_long() const;
  [[nodiscard]] std::string_view buffered() const {
    return {buffer_.data() + begin_, end_ - begin_};
  }

  int descriptor_;
  std::string name_;
  std::optional<std::uint64_t> size_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // what is buffered and not yet taken
  std::uint64_t bytes_read_ = 0;
  bool after_return_ = false;  // what follows is a new line, but for a line feed at its beginning
};

}  // namespace gonio::cli
