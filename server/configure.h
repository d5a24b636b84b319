// How every gonio server sets gRPC up, whatever it listens on.
#pragma once

#include "server/server.h"

namespace grpc {
class ServerBuilder;
}

namespace gonio {

// Message sizes, memory quota, threads. Thread safety: a function without state.
void configure(grpc::ServerBuilder& builder, const ServerOptions& options);

}  // namespace gonio
