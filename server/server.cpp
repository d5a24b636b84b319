#include "server/server.h"

#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/support/channel_arguments.h>
#include <spdlog/spdlog.h>

#include <mutex>
#include <utility>

#include "base/text/join.h"
#include "server/check_options.h"
#include "server/server_state.h"

namespace gonio::server {
namespace {

Result<std::vector<Address>> claim_all(const std::vector<std::string>& texts) {
  std::vector<Address> addresses;
  for (const std::string& text : texts) {
    auto address = parse_address(text);
    if (!address) return address.error();
    const auto claimed = claim(*address);
    if (!claimed) return claimed.error();
    addresses.push_back(std::move(*address));
  }
  return addresses;
}

// The log names what is not served.
Result<Materials> load_materials(const ServerOptions& options, spdlog::logger& logger) {
  Result<Materials> materials =
      options.materials.empty() ? Materials() : Materials::load(options.materials);
  if (!materials) return materials;
  for (const Skipped& skipped : materials->skipped())
    logger.warn("not served: {} (in {})", skipped.reason, options.materials.string());
  return materials;
}

void allow_what_is_asked_for(Materials& materials, const ServerOptions& options,
                             spdlog::logger& logger) {
  if (options.allow_local_files) materials.allow_local_files();
  const std::size_t removed = materials.allow_puts(options.put_quota_bytes);
  if (removed > 0)
    logger.info("removed {} unfinished uploads of servers that were killed", removed);
}

}  // namespace

Result<std::unique_ptr<Server>> Server::start(const ServerOptions& options) {
  const auto checked = check_options(options);
  if (!checked) return checked.error();
  const auto logger = logger_or_silence(options);
  auto materials = load_materials(options, *logger);
  if (!materials) return materials.error();
  const auto addresses = claim_all(options.addresses);
  if (!addresses) return addresses.error();
  allow_what_is_asked_for(*materials, options, *logger);
  static std::once_flag plugins;  // both are settings of the process
  std::call_once(plugins, [] {
    grpc::EnableDefaultHealthCheckService(true);
    grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  });
  auto state = std::make_unique<State>(options, std::move(*materials));
  const auto listening = state->listen(*addresses);
  if (!listening) return listening.error();
  state->grpc->GetHealthCheckService()->SetServingStatus(WireService::service_full_name(), true);
  state->logger->info("stored materials: {}, not served: {}, compute threads: {}",
                      state->materials.names().size(), state->materials.skipped().size(),
                      state->pool.threads());
  return std::unique_ptr<Server>(new Server(std::move(state)));
}

Outcome Server::check(const ServerOptions& options) {
  const auto checked = check_options(options);
  if (!checked) return checked;
  for (const std::string& text : options.addresses) {
    if (const auto address = parse_address(text); !address) return address.error();
  }
  const auto logger = logger_or_silence(options);
  const auto materials = load_materials(options, *logger);
  if (!materials) return materials.error();
  const std::size_t wrong = materials->skipped().size();
  logger->info("stored materials: {}, not served: {}", materials->names().size(), wrong);
  if (wrong == 0) return Ok{};
  std::vector<std::string> reasons;
  for (const Skipped& skipped : materials->skipped()) reasons.push_back(skipped.reason);
  return Error{ErrorCode::data_loss,
               options.materials.string() + ": " + std::to_string(wrong) +
                   " files cannot be served: " + joined(reasons, "; "),
               "materials", options.materials.string(),
               "materials that can be read, one file for each name"};
}

Server::Server(std::unique_ptr<State> state) : state_(std::move(state)) {}

Server::~Server() { shutdown(std::chrono::milliseconds(0)); }

std::shared_ptr<grpc::Channel> Server::in_process_channel() {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(static_cast<int>(state_->options.max_message_bytes));
  return state_->grpc->InProcessChannel(arguments);
}

int Server::port() const { return state_->port; }

void Server::shutdown(std::chrono::milliseconds grace) {
  bool is_first = false;
  {
    const std::lock_guard lock(state_->mutex);
    is_first = !std::exchange(state_->stopping, true);
  }
  if (!is_first) return wait();
  state_->stop(grace);
  const std::lock_guard lock(state_->mutex);
  state_->stopped = true;
  state_->stopped_changed.notify_all();
}

void Server::hurry() { state_->calls.hurry(); }

void Server::wait() {
  std::unique_lock lock(state_->mutex);
  state_->stopped_changed.wait(lock, [this] { return state_->stopped; });
}

}  // namespace gonio::server
