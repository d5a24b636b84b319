#include "client/cli/output/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

constexpr auto kPatience = std::chrono::milliseconds(500);  // what is done by then needs no bar
constexpr auto kInterval = std::chrono::milliseconds(100);
constexpr std::size_t kWidth = 40;

// "[####....]  42 %"
std::string bar(double done) {
  const auto filled = static_cast<std::size_t>(done * static_cast<double>(kWidth));
  char percent[16];
  std::snprintf(percent, sizeof(percent), "] %3.0f %%", 100 * done);
  return "[" + std::string(filled, '#') + std::string(kWidth - filled, '.') + percent;
}

}  // namespace

Progress::Progress(bool wanted, const char* items)
    : shown_(wanted && ::isatty(STDERR_FILENO) != 0), items_(items), next_(start_ + kPatience) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

bool Progress::is_due() {
  const auto now = Clock::now();
  if (!shown_ || now < next_) return false;
  next_ = now + kInterval;
  drawn_ = true;
  return true;
}

void Progress::update(std::uint64_t done, std::optional<double> fraction) {
  if (!is_due()) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = static_cast<double>(done) / seconds * 1e-6;
  if (!fraction) {
    std::fprintf(stderr, "\r\x1b[K%.1f M %s, %.1f M %s/s", static_cast<double>(done) * 1e-6, items_,
                 rate, items_);
    return;
  }
  const double part = std::clamp(*fraction, 0.0, 1.0);
  const double left = part > 0 ? seconds / part - seconds : 0;
  std::fprintf(stderr, "\r\x1b[K%s, %.1f M %s/s, %.0f s left", bar(part).c_str(), rate, items_,
               left);
}

void Progress::show(double fraction, const std::string& text) {
  if (!is_due()) return;
  std::fprintf(stderr, "\r\x1b[K%s, %s", bar(std::clamp(fraction, 0.0, 1.0)).c_str(),
               shown(text).c_str());
}

}  // namespace gonio::cli
