// goniod: serves material evaluation over gRPC.
#include <cstdio>
#include <exception>

#include "base/exit_code.h"
#include "server/configure.h"
#include "server/daemon/arguments.h"
#include "server/daemon/run.h"
#include "server/logging.h"

int main(int argc, char** argv) try {
  gonio::server::Arguments arguments;
  if (const auto code = gonio::server::parse(argc, argv, arguments)) return *code;
  const auto options = gonio::server::server_options(arguments);
  gonio::server::keep_freed_memory();
  const sigset_t signals = gonio::server::block_signals();
  gonio::server::capture_library_logs(*options.logger);
  if (arguments.check_only) return gonio::server::check(options);
  return gonio::server::serve(options, gonio::server::grace_of(arguments), signals);
} catch (const std::exception& error) {  // out of memory, or of threads
  std::fprintf(stderr, "goniod: error: %s\n", error.what());
  return gonio::exit_failed;
}
