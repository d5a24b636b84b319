#include "client/cli/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace gonio::cli {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

Error cannot_read(const std::string& name, int reason) {
  const ErrorCode code = reason == ENOENT ? ErrorCode::not_found : ErrorCode::invalid_argument;
  return {code, name + " cannot be read: " + std::strerror(reason), "--pairs", name, {}};
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
      bytes_read_(other.bytes_read_) {}

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

Result<std::optional<std::string_view>> ByteSource::line() {
  std::size_t searched = 0;
  for (;;) {
    const std::string_view text = buffered();
    const std::size_t end = text.find('\n', searched);
    if (end != std::string_view::npos || text.size() > kLongestLine) {
      if (std::min(end, text.size()) > kLongestLine) break;
      begin_ += end + 1;
      return std::optional(text.substr(0, end - (end > 0 && text[end - 1] == '\r' ? 1 : 0)));
    }
    searched = text.size();
    auto more = refill();
    if (!more) return more.error();
    if (*more) continue;
    if (begin_ == end_) return std::optional<std::string_view>{};
    const std::string_view last = buffered();  // without an end of line
    begin_ = end_;
    return std::optional(last.substr(0, last.size() - (last.back() == '\r' ? 1 : 0)));
  }
  return Error{ErrorCode::invalid_argument,
               name_ + " has a line of more than 1 MiB: it is not CSV",
               "--pairs",
               name_,
               {}};
}

}  // namespace gonio::cli
