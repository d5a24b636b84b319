#include "server/daemon/run.h"

#include <spdlog/logger.h>

#include <cstdio>
#include <cstdlib>
#include <future>

#include "base/exit_code.h"
#include "gonio/base/shown.h"

namespace gonio::server {
namespace {

using std::chrono::milliseconds;

// What is wrong with the arguments shows as such, all else as a failure.
int exit_code_at_start(const Error& error) {
  return exit_code_of(error) == exit_bad_input ? exit_bad_input : exit_failed;
}

// Whether SIGTERM or SIGINT comes within `time`. SIGHUP, which a terminal sends at its end and an
// operator for a reload, ends nothing.
bool stop_is_asked_for(const sigset_t& signals, milliseconds time, spdlog::logger& logger) {
  const timespec longest{time.count() / 1000, 1'000'000 * (time.count() % 1000)};
  const int signal = sigtimedwait(&signals, nullptr, &longest);
  if (signal == SIGHUP)
    logger.info("SIGHUP: ignored; new materials are served after the next start");
  return signal == SIGTERM || signal == SIGINT;
}

// The first signal lets calls under way end, the second cancels them, the third ends the program.
void stop_in_turn(Server& server, milliseconds grace, const sigset_t& signals,
                  spdlog::logger& logger) {
  const auto stopped = std::async(std::launch::async, [&server, grace] { server.shutdown(grace); });
  bool hurried = false;
  while (stopped.wait_for(milliseconds(0)) != std::future_status::ready) {
    if (!stop_is_asked_for(signals, milliseconds(10), logger)) continue;
    if (hurried) std::_Exit(exit_failed);
    logger.info("asked to stop again: cancels the calls under way");
    server.hurry();
    hurried = true;
  }
}

// Says what is wrong, also to those who want no log; gives the exit code.
int fail(const Error& error, spdlog::logger& logger) {
  logger.error("{}", error.message);
  if (!logger.should_log(spdlog::level::err))
    std::fprintf(stderr, "goniod: error: %s\n", shown(error.message).c_str());
  return exit_code_at_start(error);
}

}  // namespace

sigset_t block_signals() {
  std::signal(SIGPIPE, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

int serve(const ServerOptions& options, std::chrono::milliseconds grace, const sigset_t& signals) {
  spdlog::logger& logger = *options.logger;
  const auto server = Server::start(options);
  if (!server) return fail(server.error(), logger);
  while (!stop_is_asked_for(signals, std::chrono::hours(1), logger)) {
  }
  stop_in_turn(**server, grace, signals, logger);
  return exit_ok;
}

int check(const ServerOptions& options) {
  const auto checked = Server::check(options);
  return checked ? exit_ok : fail(checked.error(), *options.logger);
}

}  // namespace gonio::server
