// What a server's address may look like. Internal to the client library. Thread safety: a function
// without state.
#pragma once

#include <string_view>

#include "gonio/base/result.h"

namespace gonio::client {

// "host:port", "[::1]:port" or "unix:/path". gRPC itself takes more for an address than is one: to
// "localhost" it adds a port that nobody has asked for.
Outcome check_address(std::string_view address);

}  // namespace gonio::client
