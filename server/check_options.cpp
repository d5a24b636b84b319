#include "server/check_options.h"

#include <cstdio>
#include <string>

#include "wire/message.h"

namespace gonio::server {
namespace {

std::string octal(unsigned mode) {
  char text[16];
  (void)std::snprintf(text, sizeof text, "%04o", mode);
  return text;
}

Outcome check_socket_mode(const ServerOptions& options) {
  constexpr unsigned kOwner = 0600;
  if (!options.socket_mode ||
      (*options.socket_mode <= 0777 && (*options.socket_mode & kOwner) == kOwner))
    return Ok{};
  return bad_value("socket_mode", octal(*options.socket_mode),
                   "0600 to 0777, the owner's reading and writing among it");
}

Outcome check_fits(const ServerOptions& options) {
  if (options.fit_threads < 1 || options.fit_threads > ServerOptions::kMostThreads) {
    return bad_value("fit_threads", std::to_string(options.fit_threads),
                     "1 to " + std::to_string(ServerOptions::kMostThreads));
  }
  if (options.max_fits == 0) return bad_value("max_fits", "0", "1 or more");
  if (options.longest_fit.count() <= 0) {
    return bad_value("longest_fit", std::to_string(options.longest_fit.count()) + " ms",
                     "1 ms or more");
  }
  return Ok{};
}

}  // namespace

Outcome check_options(const ServerOptions& options) {
  if (options.threads < 0 || options.threads > ServerOptions::kMostThreads) {
    return bad_value("threads", std::to_string(options.threads),
                     "1 to " + std::to_string(ServerOptions::kMostThreads) + ", or 0 for all");
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

}  // namespace gonio::server
