#include "client/cli/input/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/text/lines.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

Error cannot_read(const std::string& name, int reason) {
  const ErrorCode code = reason == ENOENT ? ErrorCode::not_found : ErrorCode::invalid_argument;
  return {
      code, shown(name) + " cannot be read: " + std::strerror(reason), "--pairs", shown(name), {}};
}

}  // namespace

Result<ByteSource> ByteSource::open(const std::string& file) {
  const bool standard = file == "-";
  ByteSource source(standard ? STDIN_FILENO : ::open(file.c_str(), O_RDONLY | O_CLOEXEC),
                    standard ? "standard input" : file);
  struct stat info {};
  if (source.descriptor_ < 0 || fstat(source.descriptor_, &info) != 0) {
    return cannot_read(source.name_, errno);
  }
  if (S_ISDIR(info.st_mode)) return cannot_read(source.name_, EISDIR);
  if (S_ISREG(info.st_mode)) source.size_ = static_cast<std::uint64_t>(info.st_size);
  return source;
}

ByteSource::~ByteSource() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
}

ByteSource::ByteSource(ByteSource&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      name_(std::move(other.name_)),
      size_(other.size_),
      buffer_(std::move(other.buffer_)),
      begin_(other.begin_),
      end_(other.end_),
      bytes_read_(other.bytes_read_),
      after_return_(other.after_return_) {}

Result<bool> ByteSource::refill() {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (buffer_.size() - end_ < kBlock) buffer_.resize(end_ + kBlock);
  ssize_t got = 0;
  do {
    got = ::read(descriptor_, buffer_.data() + end_, buffer_.size() - end_);
  } while (got < 0 && errno == EINTR);
  if (got < 0) return cannot_read(name_, errno);
  end_ += static_cast<std::size_t>(got);
  bytes_read_ += static_cast<std::uint64_t>(got);
  return got > 0;
}

Result<std::string_view> ByteSource::peek(std::size_t count) {
  while (end_ - begin_ < count) {
    auto more = refill();
    if (!more) return more.error();
    if (!*more) break;
  }
  return buffered().substr(0, count);
}

Result<std::size_t> ByteSource::read(void* to, std::size_t count) {
  std::size_t done = 0;
  while (done < count) {
    if (begin_ == end_) {
      auto more = refill();
      if (!more) return more.error();
      if (!*more) break;
    }
    const std::size_t step = std::min(count - done, end_ - begin_);
    std::memcpy(static_cast<char*>(to) + done, buffer_.data() + begin_, step);
    begin_ += step;
    done += step;
  }
  return done;
}

void ByteSource::finish_line_end() {
  if (!after_return_ || begin_ == end_) return;
  if (buffer_[begin_] == '\n') ++begin_;
  after_return_ = false;
}

bool ByteSource::buffered_line(std::string_view& line, std::size_t searched) {
  finish_line_end();
  const std::string_view text = buffered();
  const std::size_t end = find_line_end(text, searched);
  if (end > kLongestLine) return false;  // or none is there: npos
  line = text.substr(0, end);
  begin_ += end + 1;
  // The line feed behind it may not have come yet.
  after_return_ = text[end] == '\r';
  finish_line_end();
  return true;
}

Result<bool> ByteSource::line(std::string_view& line) {
  for (std::size_t searched = 0; !buffered_line(line, searched);) {
    searched = end_ - begin_;
    if (searched > kLongestLine) return too_long();
    auto more = refill();
    if (!more) return more.error();
    if (*more) continue;
    line = buffered();  // without an end of line
    begin_ = end_;
    return !line.empty();
  }
  return true;
}

Error ByteSource::too_long() const {
  return {ErrorCode::invalid_argument,
          shown(name_) + " has a line of more than 1 MiB: it is not CSV",
          "--pairs",
          shown(name_),
          {}};
}

}  // namespace gonio::cli
