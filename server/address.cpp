#include "server/address.h"

#include <netdb.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

namespace gonio::server {
namespace {

class Socket {
 public:
  explicit Socket(int family)
      : fd_(socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {}
  ~Socket() {
    if (fd_ >= 0) close(fd_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  [[nodiscard]] int fd() const { return fd_; }

 private:
  int fd_;
};

Error cannot_listen(const Address& address, const std::string& why) {
  return {ErrorCode::unavailable, "cannot listen on " + address.text + ": " + why, "listen",
          address.text, ""};
}

// 0, or errno: whether a socket could be bound there.
int try_bind(const addrinfo& where) {
  const Socket probe(where.ai_family);
  const int yes = 1;
  if (probe.fd() < 0) return errno;
  // As gRPC does: connections of an earlier server that linger do not count.
  setsockopt(probe.fd(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  return bind(probe.fd(), where.ai_addr, where.ai_addrlen) == 0 ? 0 : errno;
}

Outcome claim_tcp(const Address& address) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int failure = getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &found);
  if (failure != 0) return cannot_listen(address, gai_strerror(failure));
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(found, &freeaddrinfo);
  bool one_is_free = false;
  int reason = 0;
  for (const addrinfo* where = found; where != nullptr; where = where->ai_next) {
    const int error = try_bind(*where);
    // A machine without IPv6 still resolves names to it: that one may fail if another works.
    if (error == EADDRINUSE || error == EACCES) return cannot_listen(address, std::strerror(error));
    one_is_free = one_is_free || error == 0;
    if (error != 0) reason = error;
  }
  if (!one_is_free) return cannot_listen(address, std::strerror(reason));
  return Ok{};
}

// A server that hangs, or has as many connections waiting as it can, answers with "again".
bool is_answered(const std::string& path) {
  sockaddr_un where{};
  where.sun_family = AF_UNIX;
  std::memcpy(where.sun_path, path.c_str(), path.size() + 1);
  const Socket probe(AF_UNIX);
  return connect(probe.fd(), reinterpret_cast<const sockaddr*>(&where), sizeof where) == 0 ||
         errno != ECONNREFUSED;
}

Outcome claim_unix(const Address& address) {
  struct stat status {};
  const std::string& path = address.path;
  const auto parent = std::filesystem::path(path).parent_path();
  const auto folder = parent.empty() ? std::filesystem::path(".") : parent;
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return cannot_listen(address, folder.string() + ": " + std::strerror(errno));
  }
  if (lstat(path.c_str(), &status) != 0) return Ok{};  // the usual case: nothing is there yet
  if (!S_ISSOCK(status.st_mode))
    return cannot_listen(address, "the file exists and is not a socket");
  if (is_answered(path)) return cannot_listen(address, "another server is listening there");
  if (unlink(path.c_str()) != 0) return cannot_listen(address, std::strerror(errno));
  return Ok{};
}

}  // namespace

Result<Address> parse_address(std::string_view text) {
  return wire::parse_address(text, "listen", 0);
}

Outcome claim(const Address& address) {
  return address.is_unix() ? claim_unix(address) : claim_tcp(address);
}

CreationMode::CreationMode(mode_t mode) : before_(::umask(0777 & ~mode)) {}

CreationMode::~CreationMode() { ::umask(before_); }

SocketFile::SocketFile(std::filesystem::path path) : path_(std::move(path)) {
  struct stat status {};
  if (lstat(path_.c_str(), &status) != 0) return;
  device_ = status.st_dev;
  inode_ = status.st_ino;
}

SocketFile::SocketFile(SocketFile&& other) noexcept
    : path_(std::exchange(other.path_, {})),
      device_(other.device_),
      inode_(std::exchange(other.inode_, 0)) {}

SocketFile::~SocketFile() {
  struct stat status {};
  if (inode_ == 0 || lstat(path_.c_str(), &status) != 0) return;
  if (status.st_dev == device_ && status.st_ino == inode_) unlink(path_.c_str());
}

}  // namespace gonio::server
