// Whether a server can run with its options. Thread safety: a function without state.
#pragma once

#include "gonio/base/result.h"
#include "server/server.h"

namespace gonio::server {

// Errors name the first option that is out of bounds.
Outcome check_options(const ServerOptions& options);

}  // namespace gonio::server
