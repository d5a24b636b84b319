// goniod's options, described to CLI11, whose header takes long to compile: it stays in this file.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

#include "base/exit_code.h"
#include "gonio/base/shown.h"
#include "gonio/base/version.h"
#include "server/arguments/completion.h"
#include "server/arguments/man_page.h"
#include "server/arguments/misuse.h"
#include "server/arguments/words.h"
#include "server/daemon/arguments.h"

namespace gonio::server {
namespace {

// The fewest digits that mean the same number.
std::string short_text(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed).ptr;
  return {text, end};
}

// Numbers between two, both included; as a CLI::Range, but "nan" is none.
CLI::Validator between(double least, double most) {
  return CLI::Validator(
      [least, most](std::string& text) {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most)
          return std::string();
        return "\"" + shown(text) + "\" is not a number from " + short_text(least) + " to " +
               short_text(most);
      },
      "[" + short_text(least) + " - " + short_text(most) + "]");
}

// An octal number, as chmod takes it.
std::string check_mode(const std::string& text) {
  const bool octal =
      !text.empty() && text.size() <= 4 && text.find_first_not_of("01234567") == std::string::npos;
  if (octal) return {};
  return "\"" + shown(text) + "\" is not an octal number of up to four digits";
}

void describe_service(CLI::App& app, Arguments& arguments) {
  ServerOptions& server = arguments.server;
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
      ->check(CLI::Range(0, ServerOptions::kMostThreads))
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
      ->check(CLI::Range(1, ServerOptions::kMostThreads))
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
  constexpr std::array kCodes{exit_ok, exit_failed, exit_bad_input};
  app.footer("\n" + exit_status_text(kCodes));
  app.add_option("--completion", arguments.completion)
      ->check(arguments::one_of(arguments::shells()))
      ->group("");
  app.add_flag("--man-page", arguments.man_page)->group("");
}

void describe(CLI::App& app, Arguments& arguments) {
  app.set_version_flag("--version", std::string("goniod ") + kVersion);
  describe_service(app, arguments);
  describe_limits(app, arguments);
  describe_fits(app, arguments);
  describe_texts(app, arguments);
  app.add_option("--log-level", arguments.log_level, "trace, debug, info, warning, error or off")
      ->check(arguments::one_of({"trace", "debug", "info", "warning", "error", "off"}))
      ->capture_default_str();
  app.add_option("--log-format", arguments.log_format, "text, or json: one object a line")
      ->check(arguments::one_of({"text", "json"}))
      ->capture_default_str();
}

// Checks that concern two options.
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

// The text that is printed in place of serving; empty: none.
std::string text_of(CLI::App& app, const Arguments& arguments) {
  if (!arguments.completion.empty()) return arguments::completion_script(app, arguments.completion);
  if (!arguments.man_page) return {};
  return arguments::man_page(app, "", std::string("gonio ") + kVersion);
}

}  // namespace

std::optional<int> parse(int argc, const char* const* argv, Arguments& arguments) {
  CLI::App app(
      "goniod serves batched BRDF evaluation over gRPC. SIGTERM or Ctrl-C stops it; a second one "
      "cancels the calls under way.",
      "goniod");
  describe(app, arguments);
  try {
    app.parse(argc, argv);
    check(arguments);
  } catch (const CLI::Success& wanted) {  // --help, --version
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "goniod: error: %s\n%s\n", shown(arguments::misuse(app, error)).c_str(),
                 arguments::where_to_read(app).c_str());
    return exit_bad_input;
  }
  const std::string text = text_of(app, arguments);
  if (text.empty()) return std::nullopt;
  std::fputs(text.c_str(), stdout);
  return exit_ok;
}

}  // namespace gonio::server
