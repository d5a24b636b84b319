// A progress bar on standard error, if that is a terminal; nothing otherwise. Thread safety: used
// by one thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace gonio::cli {

class Progress {
 public:
  // `items`: what is counted, such as "pairs".
  Progress(bool wanted, const char* items);
  ~Progress();  // takes the bar away
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `fraction` done, 0 to 1, where that is known. Draws a few times a second at most.
  void update(std::uint64_t done, std::optional<double> fraction);
  // The same for what is not counted: `text` says what goes on.
  void show(double fraction, const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;
  bool is_due();

  bool shown_;
  const char* items_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_;
};

}  // namespace gonio::cli
