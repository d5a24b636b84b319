// Where evaluations happen: on a server, or inside this process. Thread safety: used by one thread.
#pragma once

#include <optional>
#include <string>

#include "client/cli/connection/embedded_server.h"
#include "gonio/base/result.h"
#include "gonio/client/client.h"

namespace CLI {  // NOLINT(readability-identifier-naming): theirs
class App;
}

namespace gonio::cli {

struct ConnectionOptions {
  std::string server;   // empty: embedded
  double deadline = 0;  // seconds; 0 for none
  int threads = 0;      // of the embedded server; 0 for one per processor
};

// Adds --server, --deadline and --threads.
void add_connection_options(CLI::App& command, ConnectionOptions& options);

// A client and, where it is embedded, the very service that goniod runs, reached without a socket:
// the code path is the same.
struct Connection {
  std::optional<EmbeddedServer> server;  // none for a remote one; outlives the client
  client::Client client;

  static Result<Connection> open(const ConnectionOptions& options);
};

}  // namespace gonio::cli
