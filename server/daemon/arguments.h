// What goniod's command line says. Thread safety: plain values; functions without state.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "server/server.h"

namespace gonio::server {

struct Arguments {
  ServerOptions server;  // filled in as far as options stand for members as they are
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

// Reads the command line. The exit code, where there is nothing to serve: help, texts and mistakes
// have been printed then.
std::optional<int> parse(int argc, const char* const* argv, Arguments& arguments);

// The options that the arguments stand for, all in the server's units, with the logger.
ServerOptions server_options(const Arguments& arguments);

std::chrono::milliseconds grace_of(const Arguments& arguments);

}  // namespace gonio::server
