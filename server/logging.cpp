#include "server/logging.h"

#include <google/protobuf/stubs/logging.h>
#include <grpc/support/log.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <chrono>
#include <ctime>

#include "gonio/base/shown.h"

namespace gonio::server {
namespace {

spdlog::logger* captured = nullptr;  // the libraries' hooks are plain functions

constexpr std::size_t kLongestMessage = 8192;

std::string_view view(spdlog::string_view_t text) { return {text.data(), text.size()}; }

std::string shown_message(const spdlog::details::log_msg& message) {
  return shown(view(message.payload), kLongestMessage);
}

// What is shown already needs no more than these two escaped to stand in a JSON string.
void append_escaped(std::string_view text, spdlog::memory_buf_t& out) {
  for (const char c : text) {
    if (c == '"' || c == '\\') out.push_back('\\');
    out.push_back(c);
  }
}

struct Time {
  char date[32];
  int milliseconds;
};

// `split`: localtime_r or gmtime_r.
Time time_of(const spdlog::details::log_msg& message, const char* date_format,
             std::tm* (*split)(const std::time_t*, std::tm*)) {
  const auto since_epoch = message.time.time_since_epoch();
  const std::time_t seconds = std::chrono::duration_cast<std::chrono::seconds>(since_epoch).count();
  const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(since_epoch);
  std::tm parts{};
  split(&seconds, &parts);
  Time time{{}, static_cast<int>(milliseconds.count() % 1000)};
  (void)std::strftime(time.date, sizeof time.date, date_format, &parts);
  return time;
}

void take_grpc_log(gpr_log_func_args* args) {
  const auto level =
      args->severity == GPR_LOG_SEVERITY_ERROR ? spdlog::level::warn : spdlog::level::debug;
  captured->log(level, "gRPC: {}", args->message);
}

void take_protobuf_log(google::protobuf::LogLevel severity, const char*, int,
                       const std::string& message) {
  // Its errors are about bytes that clients sent; those are answered, and nothing the operator must
  // look at.
  const auto level =
      severity == google::protobuf::LOGLEVEL_FATAL ? spdlog::level::critical : spdlog::level::debug;
  captured->log(level, "protobuf: {}", message);
}

}  // namespace

void TextFormatter::format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) {
  const Time time = time_of(message, "%Y-%m-%d %H:%M:%S", &localtime_r);
  fmt::format_to(std::back_inserter(out), "{}.{:03} {} {}\n", time.date, time.milliseconds,
                 view(spdlog::level::to_string_view(message.level)), shown_message(message));
}

std::unique_ptr<spdlog::formatter> TextFormatter::clone() const {
  return std::make_unique<TextFormatter>();
}

void JsonFormatter::format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) {
  const Time time = time_of(message, "%Y-%m-%dT%H:%M:%S", &gmtime_r);
  fmt::format_to(std::back_inserter(out), R"({{"time":"{}.{:03}Z","level":"{}","message":")",
                 time.date, time.milliseconds, view(spdlog::level::to_string_view(message.level)));
  append_escaped(shown_message(message), out);
  fmt::format_to(std::back_inserter(out), "\"}}\n");
}

std::unique_ptr<spdlog::formatter> JsonFormatter::clone() const {
  return std::make_unique<JsonFormatter>();
}

std::shared_ptr<spdlog::logger> make_logger(const std::string& level, LogFormat format) {
  auto logger =
      std::make_shared<spdlog::logger>("goniod", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_level(spdlog::level::from_str(level));
  logger->flush_on(spdlog::level::trace);
  if (format == LogFormat::json) {
    logger->set_formatter(std::make_unique<JsonFormatter>());
  } else {
    logger->set_formatter(std::make_unique<TextFormatter>());
  }
  return logger;
}

void capture_library_logs(spdlog::logger& logger) {
  captured = &logger;
  gpr_set_log_function(&take_grpc_log);
  google::protobuf::SetLogHandler(&take_protobuf_log);
}

}  // namespace gonio::server
