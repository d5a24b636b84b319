#include "client/cli/connection/connection.h"

#include <cmath>
#include <utility>

#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

constexpr double kLongestDeadline = 1e9;
constexpr int kMostThreads = 1024;

}  // namespace

void add_connection_options(CLI::App& command, ConnectionOptions& options) {
  arguments::add_option(
      command, "--server", options.server,
      "The goniod to ask, HOST:PORT or unix:/PATH. Without it, the work is done in this "
      "process")
      .type_name("ADDRESS")
      .environment("GONIO_SERVER");
  arguments::add_option(command, "--deadline", options.deadline,
                        "Give up after this long; 0 for never")
      .type_name("SECONDS")
      .range(0.0, kLongestDeadline);
  arguments::add_option(command, "--threads", options.threads,
                        "Compute threads when working in this process; 0 for one per processor")
      .type_name("N")
      .range(0, kMostThreads);
}

Result<Connection> Connection::open(const ConnectionOptions& options) {
  if (std::isnan(options.deadline))  // which a range lets pass
    return bad_value("--deadline", "nan", "0 to 1e9 seconds");
  client::ClientOptions client_options;
  client_options.deadline = std::chrono::milliseconds(static_cast<long>(options.deadline * 1e3));
  // A deadline below a millisecond is still one.
  if (options.deadline > 0 && client_options.deadline.count() == 0) {
    client_options.deadline = std::chrono::milliseconds(1);
  }
  if (!options.server.empty()) {
    auto client = client::Client::connect(options.server, client_options);
    if (!client && client.error().field == "address") {
      return bad_value("--server", client.error().value, client.error().allowed);
    }
    if (!client) return std::move(client).error();
    return Connection{std::nullopt, std::move(client).value()};
  }
  auto server = EmbeddedServer::start(options.threads);
  if (!server) return std::move(server).error();
  auto client =
      client::Client::from_channel(server->channel(), "the embedded server", client_options);
  if (!client) return std::move(client).error();
  return Connection{std::move(server).value(), std::move(client).value()};
}

}  // namespace gonio::cli
