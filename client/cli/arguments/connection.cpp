#include "client/cli/arguments/connection.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <utility>

namespace gonio::cli {
namespace {

constexpr double kLongestDeadline = 1e9;
constexpr int kMostThreads = 1024;

}  // namespace

void add_connection_options(CLI::App& command, ConnectionOptions& options) {
  command
      .add_option(
          "--server", options.server,
          "The goniod to ask, HOST:PORT or unix:/PATH. Without it, the work is done in this "
          "process")
      ->type_name("ADDRESS")
      ->envname("GONIO_SERVER");
  command.add_option("--deadline", options.deadline, "Give up after this long; 0 for never")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.0, kLongestDeadline).description(""));
  command
      .add_option("--threads", options.threads,
                  "Compute threads when working in this process; 0 for one per processor")
      ->type_name("N")
      ->check(CLI::Range(0, kMostThreads).description(""));
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
    return Connection{nullptr, std::move(client).value()};
  }
  server::ServerOptions server_options;
  server_options.threads = options.threads;
  server_options.allow_local_files = true;
  server_options.fits_give_way = false;
  // What there is to protect is this process's own: a fit may have as many pairs as a message can.
  server_options.max_message_bytes = std::size_t{1} << 30;
  server_options.memory_quota_bytes = std::size_t{8} << 30;
  auto server = server::Server::start(server_options);
  if (!server) return std::move(server).error();
  auto client = client::Client::from_channel((*server)->in_process_channel(), "the embedded server",
                                             client_options);
  if (!client) return std::move(client).error();
  return Connection{std::move(server).value(), std::move(client).value()};
}

}  // namespace gonio::cli
