// Addresses of servers: the forms that server and client accept, and their translation for gRPC.
//
// gRPC reads addresses as URIs, and a client's differently from a server's: in "unix:a#b" it drops
// what follows '#', "unix:a%41" is the file aA, and "dns:80" has no host. Here a path is the file's
// name byte by byte, and gRPC gets an escaped form that names the same file or host. Clients that
// use gRPC directly must escape themselves. Thread safety: functions without state, plain values.
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
// is its name in errors. Ports begin at `least_port` (a server may ask for port 0).
Result<Address> parse_address(std::string_view text, std::string_view field, unsigned least_port);

// The form for a gRPC channel or a server's listening port.
std::string grpc_target(const Address& address);

}  // namespace gonio::wire
