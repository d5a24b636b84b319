// goniod's life after its command line is read. Thread safety: called by the main thread.
#pragma once

#include <chrono>
#include <csignal>

#include "server/server.h"

namespace gonio::server {

// Blocks the signals that end the server, and has SIGPIPE ignored. Before any thread exists, so
// that all inherit it and the signals wait for sigtimedwait().
sigset_t block_signals();

// Serves until a signal ends it; gives the exit code. `signals`: those that are blocked; `grace`:
// what calls under way have to end.
int serve(const ServerOptions& options, std::chrono::milliseconds grace, const sigset_t& signals);

// Loads everything and serves nothing; gives the exit code.
int check(const ServerOptions& options);

}  // namespace gonio::server
