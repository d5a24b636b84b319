#include "server/logging.h"

#include <google/protobuf/stubs/logging.h>
#include <grpc/support/log.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <ctime>

namespace gonio {
namespace {

spdlog::logger* captured = nullptr;  // the libraries' hooks are plain functions

// The length of the valid UTF-8 character at the start of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  // Overlong forms, surrogates and what lies beyond U+10FFFF.
  if (first == 0xE0 && byte(1) < 0xA0) return 0;
  if (first == 0xED && byte(1) > 0x9F) return 0;
  if (first == 0xF0 && byte(1) < 0x90) return 0;
  if (first == 0xF4 && byte(1) > 0x8F) return 0;
  return length;
}

void append_escaped(std::string_view text, spdlog::memory_buf_t& out) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto c = static_cast<unsigned char>(text.front());
    if (length == 0) {
      fmt::format_to(std::back_inserter(out), "\\ufffd");
    } else if (c == '"' || c == '\\') {
      fmt::format_to(std::back_inserter(out), "\\{}", text.front());
    } else if (c < 0x20 || c == 0x7F) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", c);
    } else {
      out.append(text.data(), text.data() + length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
}

std::string_view view(spdlog::string_view_t text) { return {text.data(), text.size()}; }

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

void JsonFormatter::format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) {
  const auto since_epoch = message.time.time_since_epoch();
  const std::time_t seconds = std::chrono::duration_cast<std::chrono::seconds>(since_epoch).count();
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%S", &utc);
  fmt::format_to(std::back_inserter(out), R"({{"time":"{}.{:03}Z","level":"{}","message":")", date,
                 std::chrono::duration_cast<std::chrono::milliseconds>(since_epoch).count() % 1000,
                 view(spdlog::level::to_string_view(message.level)));
  append_escaped(view(message.payload), out);
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
    logger->set_pattern("%Y-%m-%d %H:%M:%S.%e %l %v");
  }
  return logger;
}

void capture_library_logs(spdlog::logger& logger) {
  captured = &logger;
  gpr_set_log_function(&take_grpc_log);
  google::protobuf::SetLogHandler(&take_protobuf_log);
}

}  // namespace gonio
