// Logs on stderr, as text or as one JSON object a line.
#pragma once

#include <spdlog/formatter.h>
#include <spdlog/logger.h>

#include <memory>
#include <string>

namespace gonio::server {

enum class LogFormat { text, json };

// Both show the message as shown() does (gonio/base/shown.h), since requests, files and peers have
// words in it: it is one line of valid UTF-8, which can neither forge another nor command a
// terminal. "2024-01-31 12:00:00.000 info ...", in local time.
class TextFormatter final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) override;
  [[nodiscard]] std::unique_ptr<spdlog::formatter> clone() const override;
};

// {"time": "2024-01-31T12:00:00.000Z", "level": "info", "message": "..."}
class JsonFormatter final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) override;
  [[nodiscard]] std::unique_ptr<spdlog::formatter> clone() const override;
};

// `level` is one of spdlog's names. Thread safety of the logger: any thread.
std::shared_ptr<spdlog::logger> make_logger(const std::string& level, LogFormat format);

// Sends what gRPC and protobuf would print on stderr by themselves to `logger`, which must live
// until the end of the program.
void capture_library_logs(spdlog::logger& logger);

}  // namespace gonio::server
