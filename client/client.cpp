#include "gonio/client/client.h"

#include <grpc/grpc.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/channel_arguments.h>

#include <algorithm>
#include <utility>

#include "client/calls/state.h"
#include "client/messages/convert.h"
#include "client/messages/message_json.h"
#include "client/rpc/retry.h"
#include "client/rpc/rpc.h"
#include "gonio/base/shown.h"
#include "gonio/v1/models.pb.h"
#include "wire/address.h"
#include "wire/message.h"

namespace gonio::client {
namespace {

Outcome check(const ClientOptions& options) {
  if (options.chunk_pairs == 0) return bad_value("chunk_pairs", "0", "1 or more");
  if (options.in_flight < 1) {
    return bad_value("in_flight", std::to_string(options.in_flight), "1 or more");
  }
  if (options.max_retries < 0) {
    return bad_value("max_retries", std::to_string(options.max_retries), "0 or more");
  }
  if (options.connect_timeout.count() <= 0) {
    return bad_value("connect_timeout", std::to_string(options.connect_timeout.count()) + " ms",
                     "1 ms or more");
  }
  if (options.backoff.count() < 0) {
    return bad_value("backoff", std::to_string(options.backoff.count()) + " ms", "0 or more");
  }
  if (options.deadline.count() < 0) {
    return bad_value("deadline", std::to_string(options.deadline.count()) + " ms", "0 or more");
  }
  return Ok{};
}

// Without this, gRPC would stop its threads with the last client and start them again with the next
// one, and that waits (10 s and more) for connections that hang.
void keep_grpc_running() {
  static const bool kStarted = (grpc_init(), true);
  static_cast<void>(kStarted);
}

grpc::ChannelArguments arguments(const ClientOptions& options) {
  grpc::ChannelArguments arguments;
  const auto milliseconds = [](std::chrono::milliseconds time) {
    return static_cast<int>(std::clamp<std::int64_t>(time.count(), 1, 1'000'000'000));
  };
  // Each Client has a connection of its own: two of them in one program do not slow each other
  // down.
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  // A retry must find the channel willing to connect again.
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, milliseconds(options.backoff / 2));
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 1000);
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, milliseconds(options.connect_timeout));
  // A server whose machine has gone (no word of its end can come) is noticed while a call waits for
  // it.
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, 30'000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 20'000);
  // Proxies cost two thirds of the throughput; a web proxy in the environment is not meant for
  // this.
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  return arguments;
}

Result<gonio::v1::ListModelsResponse> list(const Peer& peer, const ClientOptions& options,
                                           std::string_view name) {
  gonio::v1::ListModelsRequest request;
  request.set_name(std::string(name));
  Patience patience(options, std::nullopt);
  auto bytes = call(peer, kListModelsMethod, wire::to_buffer(request), patience);
  if (!bytes) return bytes.error();
  gonio::v1::ListModelsResponse response;
  if (!wire::from_buffer(*bytes, response)) {
    return Error{ErrorCode::internal, peer.name + " sent a list that cannot be read", {}, {}, {}};
  }
  return response;
}

}  // namespace

Client::Client(std::unique_ptr<const State> state) : state_(std::move(state)) {}
Client::~Client() = default;
Client::Client(Client&&) noexcept = default;
Client& Client::operator=(Client&&) noexcept = default;

Result<Client> Client::connect(const std::string& address, const ClientOptions& options) {
  const auto where = wire::parse_address(address, "address", 1);
  if (!where) return where.error();
  return from_channel(
      grpc::CreateCustomChannel(wire::grpc_target(*where), grpc::InsecureChannelCredentials(),
                                arguments(options)),
      "the server at " + shown(address), options);
}

Result<Client> Client::from_channel(std::shared_ptr<grpc::Channel> channel, std::string name,
                                    const ClientOptions& options) {
  if (auto checked = check(options); !checked) return checked.error();
  keep_grpc_running();
  return Client(
      std::make_unique<const State>(State{Peer{std::move(channel), std::move(name)}, options}));
}

Result<Catalogue> Client::list_models(std::string_view name) const {
  auto response = list(state_->peer, state_->options, name);
  if (!response) return response.error();
  return catalogue_of(*response);
}

Result<std::string> Client::list_models_json(std::string_view name) const {
  auto response = list(state_->peer, state_->options, name);
  if (!response) return response.error();
  return json_of(*response);
}

}  // namespace gonio::client
