#include <string>

#include "server/daemon/arguments.h"
#include "server/logging.h"

namespace gonio::server {
namespace {

using std::chrono::milliseconds;

milliseconds to_milliseconds(double seconds) {
  return milliseconds(static_cast<milliseconds::rep>(1000 * seconds));
}

}  // namespace

ServerOptions server_options(const Arguments& arguments) {
  ServerOptions server = arguments.server;
  server.max_message_bytes = arguments.max_message_mb << 20;
  server.memory_quota_bytes = arguments.memory_quota_mb << 20;
  server.put_quota_bytes = arguments.put_quota_mb << 20;
  server.longest_fit = to_milliseconds(arguments.longest_fit_seconds);
  server.lame_duck = to_milliseconds(arguments.lame_duck_seconds);
  if (!arguments.socket_mode.empty())
    server.socket_mode = static_cast<unsigned>(std::stoul(arguments.socket_mode, nullptr, 8));
  server.logger = make_logger(arguments.log_level,
                              arguments.log_format == "json" ? LogFormat::json : LogFormat::text);
  return server;
}

std::chrono::milliseconds grace_of(const Arguments& arguments) {
  return to_milliseconds(arguments.grace_seconds);
}

}  // namespace gonio::server
