#include "client/cli/connection/embedded_server.h"

#include <utility>

#include "server/server.h"

namespace gonio::cli {

struct EmbeddedServer::State {
  std::unique_ptr<server::Server> server;

  static Result<EmbeddedServer> start(const server::ServerOptions& options) {
    auto server = server::Server::start(options);
    if (!server) return std::move(server).error();
    return EmbeddedServer(std::make_unique<State>(State{std::move(server).value()}));
  }
};

EmbeddedServer::EmbeddedServer(std::unique_ptr<State> state) : state_(std::move(state)) {}
EmbeddedServer::EmbeddedServer(EmbeddedServer&&) noexcept = default;
EmbeddedServer& EmbeddedServer::operator=(EmbeddedServer&&) noexcept = default;
EmbeddedServer::~EmbeddedServer() = default;

Result<EmbeddedServer> EmbeddedServer::start(int threads) {
  server::ServerOptions options;
  options.threads = threads;
  options.allow_local_files = true;
  options.fits_give_way = false;
  // What there is to protect is this process's own: a fit may have as many pairs as a message can.
  options.max_message_bytes = std::size_t{1} << 30;
  options.memory_quota_bytes = std::size_t{8} << 30;
  return State::start(options);
}

Result<EmbeddedServer> EmbeddedServer::start_at(const std::string& address, int threads) {
  server::ServerOptions options;
  options.threads = threads;
  options.addresses = {address};
  return State::start(options);
}

std::shared_ptr<grpc::Channel> EmbeddedServer::channel() const {
  return state_->server->in_process_channel();
}

}  // namespace gonio::cli
