// How every gonio server sets gRPC up, whatever it listens on.
#pragma once

#include "server/server.h"

namespace grpc {
class ServerBuilder;
}

namespace gonio::server {

// Message sizes, memory quota, threads. Thread safety: a function without state.
void configure(grpc::ServerBuilder& builder, const ServerOptions& options);

// Keeps freed memory for the next message: a megabyte fresh from the kernel costs about as much in
// page faults as evaluating the pairs that go into it (measured: a tenth of the server's time). A
// setting of the whole process, for a program that is a server; call it before there are threads.
void keep_freed_memory();

}  // namespace gonio::server
