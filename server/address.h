// The addresses a server listens on: what they may look like, whether they are free, and why not.
//
// Thread safety: plain values; a SocketFile belongs to one thread.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "gonio/base/result.h"

namespace gonio {

struct Address {
  std::string text;            // as given, and as gRPC takes it
  std::filesystem::path path;  // of a UNIX socket; empty for TCP
  std::string host;            // of TCP
  std::string port;
  [[nodiscard]] bool is_unix() const { return !path.empty(); }
};

// "host:port", "[::1]:port" or "unix:/path".
Result<Address> parse_address(std::string_view text);

// Whether it can be listened on. gRPC itself would share a TCP port or take a socket file over from
// a server that still runs, and does not say why it cannot listen. Removes a socket file that no
// server answers any more.
Outcome claim(const Address& address);

// Removes the socket file of a UNIX address at the end, unless another has taken its place.
class SocketFile {
 public:
  explicit SocketFile(std::filesystem::path path);  // the file exists already
  ~SocketFile();
  SocketFile(SocketFile&& other) noexcept;
  SocketFile& operator=(SocketFile&&) = delete;

 private:
  std::filesystem::path path_;
  ino_t inode_ = 0;
};

}  // namespace gonio
