// The addresses a server listens on: whether they are free, and why not.
//
// Thread safety: plain values; a SocketFile belongs to one thread.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "gonio/base/result.h"
#include "wire/address.h"

namespace gonio::server {

using Address = wire::Address;

// As wire::parse_address() does, for option "listen".
Result<Address> parse_address(std::string_view text);

// Whether it can be listened on. gRPC itself would share a TCP port or take a socket file over from
// a server that still runs, and does not say why it cannot listen. Removes a socket file that no
// server answers any more.
Outcome claim(const Address& address);

// While it lives, the sockets that are bound, and the files that are created, have at most `mode`:
// from the first moment on, as no chmod() could. Concerns the whole process, all of its threads.
class CreationMode {
 public:
  explicit CreationMode(mode_t mode);
  ~CreationMode();
  CreationMode(const CreationMode&) = delete;
  CreationMode& operator=(const CreationMode&) = delete;

 private:
  mode_t before_;
};

// Removes the socket file of a UNIX address at the end, unless another has taken its place.
class SocketFile {
 public:
  explicit SocketFile(std::filesystem::path path);  // the file exists already
  ~SocketFile();
  SocketFile(SocketFile&& other) noexcept;
  SocketFile& operator=(SocketFile&&) = delete;

 private:
  std::filesystem::path path_;
  dev_t device_ = 0;
  ino_t inode_ = 0;  // 0: nothing to remove
};

}  // namespace gonio::server
