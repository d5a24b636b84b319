// goniod: serves material evaluation over gRPC.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <future>
#include <string>

#include "base/exit_code.h"
#include "gonio/base/shown.h"
#include "gonio/base/version.h"
#include "server/arguments/completion.h"
#include "server/arguments/man_page.h"
#include "server/arguments/misuse.h"
#include "server/arguments/words.h"
#include "server/configure.h"
#include "server/logging.h"
#include "server/server.h"

namespace {

using std::chrono::milliseconds;

struct Arguments {
  gonio::server::ServerOptions server;
  std::size_t max_message_mb = 64;
  std::size_t memory_quota_mb = 1024;
  std::size_t put_quota_mb = 1024;
  double longest_fit_seconds = 600;
  double lame_duck_seconds = 0.5;
  double grace_seconds = 5;
  std::string log_level = "info";
  std::string log_format = "text";
  std::string socket_mode;
  bool check_only = false;
  std::string completion;  // a shell, in place of serving
  bool man_page = false;
};

// Numbers between two, both included; as a CLI::Range, but "nan" is none.
CLI::Validator between(double least, double most) {
  return CLI::Validator(
      [least, most](std::string& text) {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most)
          return std::string();
        return fmt::format("\"{}\" is not a number from {} to {}", gonio::shown(text), least, most);
      },
      fmt::format("[{} - {}]", least, most));
}

// An octal number, as chmod takes it.
std::string check_mode(const std::string& text) {
  const bool octal =
      !text.empty() && text.size() <= 4 && text.find_first_not_of("01234567") == std::string::npos;
  if (octal) return {};
  return "\"" + gonio::shown(text) + "\" is not an octal number of up to four digits";
}

void describe_service(CLI::App& app, Arguments& arguments) {
  gonio::server::ServerOptions& server = arguments.server;
  server.addresses = {"127.0.0.1:50051"};
  app.add_option(
         "-l,--listen", server.addresses,
         "Where to listen: host:port (0 takes a free port) or unix:PATH; several are allowed")
      ->capture_default_str();
  app.add_option(
         "--socket-mode", arguments.socket_mode,
         "Who may connect to the unix: sockets, as chmod says it: 0660; without it, what the "
         "umask leaves")
      ->type_name("MODE")
      ->check(CLI::Validator(check_mode, ""));
  app.add_option(
         "-m,--materials", server.materials,
         "Serve every material .json and MERL .binary of this folder under its name, but those "
         "that cannot be used; if it can be written to, materials that clients put go there, else "
         "into memory")
      ->type_name("DIR");
  app.add_flag(
      "--check", arguments.check_only,
      "Load everything, report what cannot be used and exit with status 2 if anything cannot; "
      "serve nothing");
  app.add_option("-t,--threads", server.threads, "Compute threads; 0: one per processor")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  app.add_option("--max-queue", server.max_queued_jobs,
                 "Batches queued or computed at a time; more are refused")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
}

void describe_limits(CLI::App& app, Arguments& arguments) {
  app.add_option("--max-message-mb", arguments.max_message_mb,
                 "Largest message received or sent, in MiB")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--memory-quota-mb", arguments.memory_quota_mb,
                 "What requests and answers may hold, and gRPC's buffers beside them, in MiB each; "
                 "at least --max-message-mb")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  app.add_option(
         "--put-quota-mb", arguments.put_quota_mb,
         "What materials that clients put may hold, all together, in MiB; 0: none are taken")
      ->check(CLI::Range(0, 1 << 20))
      ->capture_default_str();
  app.add_option(
         "--lame-duck", arguments.lame_duck_seconds,
         "Seconds to go on serving after a stop was asked for, already reporting NOT_SERVING")
      ->check(between(0, 3600))
      ->capture_default_str();
  app.add_option(
         "--grace", arguments.grace_seconds,
         "Seconds that calls under way then have to end; where there are none, none are spent")
      ->check(between(0, 3600))
      ->capture_default_str();
}

void describe_fits(CLI::App& app, Arguments& arguments) {
  app.add_option("--fit-threads", arguments.server.fit_threads,
                 "Threads for fits, beside the compute threads and at the lowest priority")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--max-fits", arguments.server.max_fits,
                 "Fits that wait or run at a time; more are refused")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  app.add_option("--longest-fit", arguments.longest_fit_seconds,
                 "Seconds after which a fit is given up, waiting included")
      ->check(between(0.001, 1e6))
      ->capture_default_str();
}

// For installations: what they make of these arguments. Not part of the help.
void describe_texts(CLI::App& app, Arguments& arguments) {
  constexpr std::array kCodes{gonio::exit_ok, gonio::exit_failed, gonio::exit_bad_input};
  app.footer("\n" + gonio::exit_status_text(kCodes));
  app.add_option("--completion", arguments.completion)
      ->check(gonio::arguments::one_of(gonio::arguments::shells()))
      ->group("");
  app.add_flag("--man-page", arguments.man_page)->group("");
}

void describe(CLI::App& app, Arguments& arguments) {
  app.set_version_flag("--version", std::string("goniod ") + gonio::kVersion);
  describe_service(app, arguments);
  describe_limits(app, arguments);
  describe_fits(app, arguments);
  describe_texts(app, arguments);
  app.add_option("--log-level", arguments.log_level, "trace, debug, info, warning, error or off")
      ->check(gonio::arguments::one_of({"trace", "debug", "info", "warning", "error", "off"}))
      ->capture_default_str();
  app.add_option("--log-format", arguments.log_format, "text, or json: one object a line")
      ->check(gonio::arguments::one_of({"text", "json"}))
      ->capture_default_str();
}

// What no option can be checked for by itself.
void check(const Arguments& arguments) {
  const auto& addresses = arguments.server.addresses;
  if (arguments.memory_quota_mb < arguments.max_message_mb) {
    throw CLI::ValidationError("--memory-quota-mb", std::to_string(arguments.memory_quota_mb) +
                                                        " is less than --max-message-mb, " +
                                                        std::to_string(arguments.max_message_mb));
  }
  if (!arguments.socket_mode.empty() &&
      std::none_of(addresses.begin(), addresses.end(),
                   [](const std::string& address) { return address.rfind("unix:", 0) == 0; })) {
    throw CLI::ValidationError("--socket-mode",
                               arguments.socket_mode + " is for unix: sockets; no --listen is one");
  }
}

milliseconds to_milliseconds(double seconds) {
  return milliseconds(static_cast<milliseconds::rep>(1000 * seconds));
}

// Before any thread exists, so that all inherit it and the signals wait for sigtimedwait().
sigset_t block_signals() {
  std::signal(SIGPIPE, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

// What is wrong with the arguments shows as such, all else as a failure.
int exit_code_at_start(const gonio::Error& error) {
  return gonio::exit_code_of(error) == gonio::exit_bad_input ? gonio::exit_bad_input
                                                             : gonio::exit_failed;
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
void stop_in_turn(gonio::server::Server& server, milliseconds grace, const sigset_t& signals,
                  spdlog::logger& logger) {
  const auto stopped = std::async(std::launch::async, [&server, grace] { server.shutdown(grace); });
  bool hurried = false;
  while (stopped.wait_for(milliseconds(0)) != std::future_status::ready) {
    if (!stop_is_asked_for(signals, milliseconds(10), logger)) continue;
    if (hurried) std::_Exit(gonio::exit_failed);
    logger.info("asked to stop again: cancels the calls under way");
    server.hurry();
    hurried = true;
  }
}

void fill_in(Arguments& arguments) {
  gonio::server::ServerOptions& server = arguments.server;
  server.max_message_bytes = arguments.max_message_mb << 20;
  server.memory_quota_bytes = arguments.memory_quota_mb << 20;
  server.put_quota_bytes = arguments.put_quota_mb << 20;
  server.longest_fit = to_milliseconds(arguments.longest_fit_seconds);
  server.lame_duck = to_milliseconds(arguments.lame_duck_seconds);
  if (!arguments.socket_mode.empty())
    server.socket_mode = static_cast<unsigned>(std::stoul(arguments.socket_mode, nullptr, 8));
  server.logger = gonio::server::make_logger(
      arguments.log_level, arguments.log_format == "json" ? gonio::server::LogFormat::json
                                                          : gonio::server::LogFormat::text);
}

// Says what is wrong, also to those who want no log; gives the exit code.
int fail(const gonio::Error& error, spdlog::logger& logger) {
  logger.error("{}", error.message);
  if (!logger.should_log(spdlog::level::err))
    std::fprintf(stderr, "goniod: error: %s\n", gonio::shown(error.message).c_str());
  return exit_code_at_start(error);
}

int serve(const Arguments& arguments, const sigset_t& signals) {
  spdlog::logger& logger = *arguments.server.logger;
  gonio::server::capture_library_logs(logger);
  if (arguments.check_only) {
    const auto checked = gonio::server::Server::check(arguments.server);
    return checked ? 0 : fail(checked.error(), logger);
  }
  const auto server = gonio::server::Server::start(arguments.server);
  if (!server) return fail(server.error(), logger);
  while (!stop_is_asked_for(signals, std::chrono::hours(1), logger)) {
  }
  stop_in_turn(**server, to_milliseconds(arguments.grace_seconds), signals, logger);
  return 0;
}

// What is printed in place of serving; empty: nothing.
std::string text_of(CLI::App& app, const Arguments& arguments) {
  if (!arguments.completion.empty())
    return gonio::arguments::completion_script(app, arguments.completion);
  if (!arguments.man_page) return {};
  return gonio::arguments::man_page(app, "", std::string("gonio ") + gonio::kVersion);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app(
      "goniod serves batched BRDF evaluation over gRPC. SIGTERM or Ctrl-C stops it; a second one "
      "cancels the calls under way.",
      "goniod");
  Arguments arguments;
  describe(app, arguments);
  try {
    app.parse(argc, argv);
    check(arguments);
  } catch (const CLI::Success& wanted) {  // --help, --version
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "goniod: error: %s\n%s\n",
                 gonio::shown(gonio::arguments::misuse(app, error)).c_str(),
                 gonio::arguments::where_to_read(app).c_str());
    return gonio::exit_bad_input;
  }
  if (const std::string text = text_of(app, arguments); !text.empty()) {
    std::fputs(text.c_str(), stdout);
    return gonio::exit_ok;
  }
  fill_in(arguments);
  gonio::server::keep_freed_memory();
  const sigset_t signals = block_signals();
  return serve(arguments, signals);
} catch (const std::exception& error) {  // out of memory, or of threads
  std::fprintf(stderr, "goniod: error: %s\n", error.what());
  return gonio::exit_failed;
}
