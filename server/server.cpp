#include "server/server.h"

#include <grpc/grpc.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/health_check_service_interface.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <condition_variable>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "gonio/engine/thread_pool.h"
#include "server/address.h"
#include "server/configure.h"
#include "server/materials/materials.h"
#include "server/service.h"
#include "server/work/calls_under_way.h"
#include "wire/message.h"

namespace gonio::server {
namespace {

constexpr int kMaxThreads = 1024;
constexpr std::chrono::milliseconds kEndingStep{5};
constexpr std::size_t kMaxPuts = 64;  // complete uploads that wait to be stored

std::shared_ptr<spdlog::logger> logger_or_silence(const ServerOptions& options) {
  if (options.logger) return options.logger;
  return std::make_shared<spdlog::logger>("gonio", std::make_shared<spdlog::sinks::null_sink_mt>());
}

int threads_of(const ServerOptions& options) {
  return options.threads > 0 ? options.threads
                             : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

Outcome check_socket_mode(const ServerOptions& options) {
  constexpr unsigned kOwner = 0600;
  if (!options.socket_mode ||
      (*options.socket_mode <= 0777 && (*options.socket_mode & kOwner) == kOwner))
    return Ok{};
  return bad_value("socket_mode", fmt::format("{:04o}", *options.socket_mode),
                   "0600 to 0777, the owner's reading and writing among it");
}

Outcome check_fits(const ServerOptions& options) {
  if (options.fit_threads < 1 || options.fit_threads > kMaxThreads) {
    return bad_value("fit_threads", std::to_string(options.fit_threads),
                     "1 to " + std::to_string(kMaxThreads));
  }
  if (options.max_fits == 0) return bad_value("max_fits", "0", "1 or more");
  if (options.longest_fit.count() <= 0) {
    return bad_value("longest_fit", std::to_string(options.longest_fit.count()) + " ms",
                     "1 ms or more");
  }
  return Ok{};
}

Outcome check_options(const ServerOptions& options) {
  if (options.threads < 0 || options.threads > kMaxThreads) {
    return bad_value("threads", std::to_string(options.threads),
                     "1 to " + std::to_string(kMaxThreads) + ", or 0 for all");
  }
  constexpr std::size_t kLeast = std::size_t{64} << 10, kMost = wire::kLargestMessage;
  if (options.max_message_bytes < kLeast || options.max_message_bytes > kMost) {
    return bad_value("max_message_bytes", std::to_string(options.max_message_bytes),
                     std::to_string(kLeast) + " to " + std::to_string(kMost));
  }
  if (options.memory_quota_bytes < options.max_message_bytes) {
    return bad_value("memory_quota_bytes", std::to_string(options.memory_quota_bytes),
                     "at least max_message_bytes, " + std::to_string(options.max_message_bytes));
  }
  if (options.max_queued_jobs == 0) return bad_value("max_queued_jobs", "0", "1 or more");
  if (auto mode = check_socket_mode(options); !mode) return mode;
  return check_fits(options);
}

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

struct Server::State {
  State(const ServerOptions& given, Materials loaded)
      : options(given),
        logger(logger_or_silence(given)),
        materials(std::move(loaded)),
        memory(given.memory_quota_bytes),
        pool(threads_of(given), given.max_queued_jobs),
        fits(given.fit_threads, given.max_fits, given.fits_give_way),
        puts(1, kMaxPuts),
        service({materials, pool, given.max_message_bytes, given.max_queued_jobs, *logger, memory,
                 FitBackend{fits, given.longest_fit, given.fits_give_way}, puts, calls}) {}

  Outcome listen(const std::vector<Address>& addresses);
  void stop(std::chrono::milliseconds grace);

  ServerOptions options;
  std::shared_ptr<spdlog::logger> logger;
  Materials materials;
  MemoryBudget memory;
  CallsUnderWay calls;
  ThreadPool pool;             // outlived by nothing that uses it: the calls end with `grpc`
  BackgroundQueue fits, puts;  // likewise
  Service service;
  std::unique_ptr<grpc::Server> grpc;
  std::vector<SocketFile> socket_files;
  int port = 0;

  std::mutex mutex;
  std::condition_variable stopped_changed;
  bool stopping = false;
  bool stopped = false;
};

Outcome Server::State::listen(const std::vector<Address>& addresses) {
  grpc::ServerBuilder builder;
  configure(builder, options);
  builder.RegisterService(&service);
  std::vector<int> ports(addresses.size(), 0);
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    builder.AddListeningPort(wire::grpc_target(addresses[i]), grpc::InsecureServerCredentials(),
                             &ports[i]);
  }
  {
    std::optional<CreationMode> mode;
    if (options.socket_mode) mode.emplace(*options.socket_mode);
    grpc = builder.BuildAndStart();
  }
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    const std::string& text = addresses[i].text;
    if (ports[i] <= 0)
      return Error{ErrorCode::unavailable, "cannot listen on " + text, "listen", text, ""};
    if (addresses[i].is_unix()) {
      socket_files.emplace_back(addresses[i].path);
      const std::string target = wire::grpc_target(addresses[i]);
      logger->info("listening on {}{}", text,
                   target == text ? "" : ", for other users of gRPC " + target);
    } else {
      if (port == 0) port = ports[i];
      logger->info("listening on {}:{}", text.substr(0, text.rfind(':')), ports[i]);
    }
  }
  if (!grpc) return Error{ErrorCode::internal, "the gRPC server cannot be started", "", "", ""};
  return Ok{};
}

// gRPC's own end waits for connections too, which clients keep open for as long as they like: so it
// is begun, and once no call is under way what is left is ended.
void Server::State::stop(std::chrono::milliseconds grace) {
  using Clock = CallsUnderWay::Clock;
  logger->info(
      "stopping: reports NOT_SERVING, waits {} ms, then up to {} ms for the calls under way",
      options.lame_duck.count(), grace.count());
  grpc->GetHealthCheckService()->Shutdown();
  calls.wait_until(Clock::now() + options.lame_duck);
  const auto ended = std::async(
      std::launch::async,
      [this, deadline = std::chrono::system_clock::now() + grace] { grpc->Shutdown(deadline); });
  calls.wait_for_none(Clock::now() + grace);
  do {
    grpc_server_cancel_all_calls(grpc->c_server());
  } while (ended.wait_for(kEndingStep) != std::future_status::ready);
  socket_files.clear();
  logger->info("stopped");
}

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
  std::string reasons;
  for (const Skipped& skipped : materials->skipped())
    reasons += (reasons.empty() ? "" : "; ") + skipped.reason;
  return Error{ErrorCode::data_loss,
               options.materials.string() + ": " + std::to_string(wrong) +
                   " files cannot be served: " + reasons,
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
