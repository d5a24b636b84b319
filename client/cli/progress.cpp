#include "client/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace gonio::cli {
namespace {

constexpr auto kPatience = std::chrono::milliseconds(500);  // what is done by then needs no bar
constexpr auto kInterval = std::chrono::milliseconds(100);
constexpr std::size_t kWidth = 40;

}  // namespace

Progress::Progress(bool wanted, const char* items)
    : shown_(wanted && ::isatty(STDERR_FILENO) != 0), items_(items), next_(start_ + kPatience) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::update(std::uint64_t done, std::optional<double> fraction) {
  if (!shown_) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + kInterval;
  drawn_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(done) / seconds * 1e-6;
  if (!fraction) {
    std::fprintf(stderr, "\r\x1b[K%.1f M %s, %.1f M %s/s", static_cast<double>(done) * 1e-6, items_,
                 rate, items_);
    return;
  }
  const double part = std::clamp(*fraction, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(part * static_cast<double>(kWidth));
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  const double left = part > 0 ? seconds / part - seconds : 0;
  std::fprintf(stderr, "\r\x1b[K[%s] %3.0f %%, %.1f M %s/s, %.0f s left", bar.c_str(), 100 * part,
               rate, items_, left);
}

}  // namespace gonio::cli
