#include "server/server_state.h"

#include <grpc/grpc.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server_builder.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <future>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "server/configure.h"

namespace gonio::server {
namespace {

constexpr std::chrono::milliseconds kEndingStep{5};
constexpr std::size_t kMaxPuts = 64;  // complete uploads that wait to be stored

int threads_of(const ServerOptions& options) {
  return options.threads > 0 ? options.threads
                             : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

std::shared_ptr<spdlog::logger> logger_or_silence(const ServerOptions& options) {
  if (options.logger) return options.logger;
  return std::make_shared<spdlog::logger>("gonio", std::make_shared<spdlog::sinks::null_sink_mt>());
}

Server::State::State(const ServerOptions& given, Materials loaded)
    : options(given),
      logger(logger_or_silence(given)),
      materials(std::move(loaded)),
      memory(given.memory_quota_bytes),
      pool(threads_of(given), given.max_queued_jobs),
      fits(given.fit_threads, given.max_fits, given.fits_give_way),
      puts(1, kMaxPuts),
      service({materials, pool, given.max_message_bytes, given.max_queued_jobs, *logger, memory,
               FitBackend{fits, given.longest_fit, given.fits_give_way}, puts, calls}) {}

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

}  // namespace gonio::server
