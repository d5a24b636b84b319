// Where a server is reached: the addresses that server and client take alike, and what gRPC is
// given for them.
//
// gRPC itself reads addresses as URIs, a client's otherwise than a server's: in "unix:a#b" it drops
// what follows '#', "unix:a%41" is the file aA, and "dns:80" no host at all. Here a path is the
// file's name byte by byte, and what gRPC is given is escaped so that it comes to the same file or
// host. Clients that use gRPC by themselves escape by themselves. Thread safety: functions without
// state, plain values.
#pragma once

#include <string>
#include <string_view>

#include "gonio/base/result.h"

namespace gonio::wire {

struct Address {
  std::string text;  // "host:port", "[::1]:port" or "unix:PATH"
  std::string path;  // of a UNIX socket; empty for TCP
  std::string host;  // of TCP, without brackets
  std::string port;
  [[nodiscard]] bool is_unix() const { return !path.empty(); }
};

// "host:port", "[::1]:port", "unix:PATH" or "unix:///PATH", the path relative or absolute. `field`
// is what errors call it; ports begin at `least_port` (a server may ask for port 0).
Result<Address> parse_address(std::string_view text, std::string_view field, unsigned least_port);

// What a channel or a server's listening port is made with.
std::string grpc_target(const Address& address);

}  // namespace gonio::wire
