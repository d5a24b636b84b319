#include "client/client.h"

#include <google/protobuf/util/json_util.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/channel_arguments.h>

#include <algorithm>
#include <array>
#include <utility>

#include "client/chunks.h"
#include "client/convert.h"
#include "client/evaluation.h"
#include "client/retry.h"
#include "client/rpc.h"
#include "gonio/v1/models.pb.h"

namespace gonio::client {

struct Client::State {
  Peer peer;
  ClientOptions options;

  [[nodiscard]] Evaluation evaluation(const Material& material, Precision precision,
                                      const EvaluateOptions& evaluate_options) const {
    return {peer, options, evaluate_options, material, precision};
  }
};

namespace {

Outcome check(const ClientOptions& options) {
  if (options.chunk_pairs == 0) return bad_value("chunk_pairs", "0", "1 or more");
  if (options.in_flight < 1) {
    return bad_value("in_flight", std::to_string(options.in_flight), "1 or more");
  }
  if (options.max_retries < 0) {
    return bad_value("max_retries", std::to_string(options.max_retries), "0 or more");
  }
  if (options.deadline.count() < 0) {
    return bad_value("deadline", std::to_string(options.deadline.count()) + " ms", "0 or more");
  }
  return Ok{};
}

grpc::ChannelArguments arguments(const ClientOptions& options) {
  grpc::ChannelArguments arguments;
  const int connect_timeout = static_cast<int>(options.connect_timeout.count());
  const int backoff = static_cast<int>(options.backoff.count());
  // Each Client has a connection of its own: two of them in one program do not slow each other
  // down.
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  // A retry must find the channel willing to connect again.
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, std::max(backoff / 2, 1));
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 1000);
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, std::max(connect_timeout, 1));
  // Proxies cost two thirds of the throughput; a web proxy in the environment is not meant for
  // this.
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  return arguments;
}

template <class Message>
grpc::ByteBuffer to_buffer(const Message& message) {
  const grpc::Slice slice(message.SerializeAsString());
  return {&slice, 1};
}

Result<gonio::v1::ListModelsResponse> list(const Peer& peer, const ClientOptions& options,
                                           std::string_view name) {
  gonio::v1::ListModelsRequest request;
  request.set_name(std::string(name));
  Patience patience(options, std::nullopt);
  auto bytes = call(peer, kListModelsMethod, to_buffer(request), patience);
  if (!bytes) return bytes.error();
  gonio::v1::ListModelsResponse response;
  if (!grpc::SerializationTraits<gonio::v1::ListModelsResponse>::Deserialize(&*bytes, &response)
           .ok()) {
    return Error{ErrorCode::internal, peer.name + " sent a list that cannot be read", {}, {}, {}};
  }
  return response;
}

template <class Out>
Outcome check_results(std::uint64_t pairs, std::span<Out> values, std::span<std::uint8_t> flags) {
  const bool whole = pairs == 0 ? values.empty() : values.size() % pairs == 0;
  const std::size_t channels = pairs == 0 ? 1 : values.size() / pairs;
  if (!whole || channels < 1 || channels > kMaxChannels) {
    return bad_value("the length of values", std::to_string(values.size()),
                     std::to_string(pairs) + " pairs x the material's channels (1 to 64)");
  }
  if (!flags.empty() && flags.size() != pairs) {
    return bad_value("the length of flags", std::to_string(flags.size()),
                     "0, or one byte for each of the " + std::to_string(pairs) + " pairs");
  }
  return Ok{};
}

// No pairs: the material is checked all the same, and the report says what it is.
Result<Report> evaluate_nothing(Evaluation& evaluation) {
  auto report = evaluation.probe();
  if (!report) return report;
  report->pairs = 0;
  report->kernel_seconds = 0;
  return report;
}

template <class Out>
Result<Report> evaluate_into(Evaluation& evaluation, ChunkSource& source, std::uint64_t pairs,
                             std::span<Out> values, std::span<std::uint8_t> flags) {
  if (auto fit = check_results(pairs, values, flags); !fit) return fit.error();
  if (pairs == 0) return evaluate_nothing(evaluation);
  ArrayReceiver<Out> receiver(values, flags, pairs);
  return evaluation.run(source, receiver, values.size() / pairs, pairs);
}

template <class Out>
constexpr Precision precision_for() {
  return std::is_same_v<Out, double> ? Precision::reference : Precision::fast;
}

template <class In, class Out>
Result<Report> evaluate_pairs(Evaluation evaluation, std::span<const In> wi, std::span<const In> wo,
                              std::span<Out> values, std::span<std::uint8_t> flags) {
  if (wi.size() % 3 != 0) {
    return bad_value("the length of wi", std::to_string(wi.size()), "a multiple of 3");
  }
  if (wo.size() != wi.size()) {
    return bad_value("the length of wo", std::to_string(wo.size()),
                     "that of wi, " + std::to_string(wi.size()));
  }
  ArraySource<In> source(wi, wo);
  return evaluate_into(evaluation, source, wi.size() / 3, values, flags);
}

template <class Out>
Result<Report> evaluate_grid(Evaluation evaluation, const Grid& grid, std::span<Out> values,
                             std::span<std::uint8_t> flags) {
  if (auto checked = check(grid); !checked) return checked.error();
  evaluation.set_grid(grid);
  GridSource source(*grid.size());
  return evaluate_into(evaluation, source, *grid.size(), values, flags);
}

template <class In, class Out>
Result<Report> evaluate_to_sink(Evaluation& evaluation, ChunkSource& source,
                                const ChunkSink<In, Out>& sink,
                                std::optional<std::uint64_t> total) {
  auto probed = evaluation.probe();
  if (!probed) return probed;
  SinkReceiver<In, Out> receiver(sink);
  auto report = evaluation.run(source, receiver, static_cast<std::size_t>(probed->channels), total);
  if (!report || report->pairs != 0) return report;
  probed->pairs = 0;
  probed->kernel_seconds = 0;
  return probed;
}

}  // namespace

Client::Client(std::unique_ptr<const State> state) : state_(std::move(state)) {}
Client::~Client() = default;
Client::Client(Client&&) noexcept = default;
Client& Client::operator=(Client&&) noexcept = default;

Result<Client> Client::connect(const std::string& address, const ClientOptions& options) {
  if (address.empty()) return bad_value("address", "empty", "host:port or unix:/path");
  return from_channel(
      grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments(options)),
      "the server at " + address, options);
}

Result<Client> Client::from_channel(std::shared_ptr<grpc::Channel> channel, std::string name,
                                    const ClientOptions& options) {
  if (auto checked = check(options); !checked) return checked.error();
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
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(*response, &json, options);
  if (!status.ok()) return Error{ErrorCode::internal, status.ToString(), {}, {}, {}};
  return json;
}

Result<int> Client::channels(const Material& material) const {
  auto report = state_->evaluation(material, Precision::fast, {}).probe();
  if (!report) return report.error();
  return report->channels;
}

Result<Report> Client::evaluate(const Material& material, std::span<const float> wi,
                                std::span<const float> wo, std::span<float> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_pairs(state_->evaluation(material, Precision::fast, options), wi, wo, values,
                        flags);
}

Result<Report> Client::evaluate(const Material& material, std::span<const float> wi,
                                std::span<const float> wo, std::span<double> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_pairs(state_->evaluation(material, Precision::reference, options), wi, wo, values,
                        flags);
}

Result<Report> Client::evaluate(const Material& material, std::span<const double> wi,
                                std::span<const double> wo, std::span<double> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_pairs(state_->evaluation(material, Precision::reference, options), wi, wo, values,
                        flags);
}

Result<Report> Client::evaluate(const Material& material, const Grid& grid, std::span<float> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_grid(state_->evaluation(material, Precision::fast, options), grid, values, flags);
}

Result<Report> Client::evaluate(const Material& material, const Grid& grid,
                                std::span<double> values, std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_grid(state_->evaluation(material, Precision::reference, options), grid, values,
                       flags);
}

template <class In, class Out>
Result<Report> Client::evaluate_chunks(const Material& material, const PairSource<In>& source,
                                       const ChunkSink<In, Out>& sink,
                                       const EvaluateOptions& options) const {
  Evaluation evaluation = state_->evaluation(material, precision_for<Out>(), options);
  CallbackSource<In> chunks(source);
  return evaluate_to_sink(evaluation, chunks, sink, std::nullopt);
}

template <class Out>
Result<Report> Client::evaluate_chunks(const Material& material, const Grid& grid,
                                       const ChunkSink<Out, Out>& sink,
                                       const EvaluateOptions& options) const {
  if (auto checked = check(grid); !checked) return checked.error();
  Evaluation evaluation = state_->evaluation(material, precision_for<Out>(), options);
  evaluation.set_grid(grid);
  GridSource chunks(*grid.size());
  return evaluate_to_sink(evaluation, chunks, sink, grid.size());
}

template Result<Report> Client::evaluate_chunks(const Material&, const PairSource<float>&,
                                                const ChunkSink<float, float>&,
                                                const EvaluateOptions&) const;
template Result<Report> Client::evaluate_chunks(const Material&, const PairSource<float>&,
                                                const ChunkSink<float, double>&,
                                                const EvaluateOptions&) const;
template Result<Report> Client::evaluate_chunks(const Material&, const PairSource<double>&,
                                                const ChunkSink<double, double>&,
                                                const EvaluateOptions&) const;
template Result<Report> Client::evaluate_chunks(const Material&, const Grid&,
                                                const ChunkSink<float, float>&,
                                                const EvaluateOptions&) const;
template Result<Report> Client::evaluate_chunks(const Material&, const Grid&,
                                                const ChunkSink<double, double>&,
                                                const EvaluateOptions&) const;

}  // namespace gonio::client
