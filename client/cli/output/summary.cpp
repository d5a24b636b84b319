#include "client/cli/output/summary.h"

#include <algorithm>
#include <bit>
#include <cstdarg>
#include <cstdio>

#include "client/cli/output/terminal.h"

namespace gonio::cli {
namespace {

[[gnu::format(printf, 1, 2)]] std::string format(const char* text, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, text);
  std::vsnprintf(buffer, sizeof(buffer), text, arguments);
  va_end(arguments);
  return buffer;
}

constexpr std::size_t kHoleBit = std::countr_zero(static_cast<unsigned>(client::flag::hole));

}  // namespace

std::string hole_summary(const client::Report& report, const std::string& items) {
  const std::uint64_t met = report.flagged_by[kHoleBit];
  if (met == 0) return {};
  return format(
      "%llu of %llu %s (%.3g %%) met holes of the table, cells that are masked or were not "
      "measured; their values stand",
      static_cast<unsigned long long>(met), static_cast<unsigned long long>(report.pairs),
      items.c_str(), 100 * static_cast<double>(met) / static_cast<double>(report.pairs));
}

std::string flag_summary(const client::Report& report, const std::string& items) {
  if (report.flagged == 0) return {};
  std::string text = std::to_string(report.flagged) + " of " + std::to_string(report.pairs) + " " +
                     items +
                     (report.flagged == 1 ? " is flagged and has the value 0: "
                                          : " are flagged and have the value 0: ");
  const char* separator = "";
  for (std::size_t bit = 0; bit < client::kFlagBits; ++bit) {
    if (bit == kHoleBit || report.flagged_by[bit] == 0) continue;
    text += separator + std::to_string(report.flagged_by[bit]) + " ";
    text += client::flag_meaning(bit);
    separator = ", ";
  }
  return text;
}

std::string bound_text(const client::ErrorBound& bound) {
  std::string text = format("relative error <= %.3g where f > %.3g and the cosines > %.3g",
                            bound.relative, bound.above, bound.cosine);
  if (!bound.note.empty()) text += " (" + bound.note + ")";
  return text;
}

std::string report_line(const client::Report& report, const std::string& items, double seconds) {
  const auto pairs = static_cast<double>(report.pairs);
  std::string text =
      format("%llu %s x %d channels in %.3f s (%.3g M %s/s); kernels %.4f s",
             static_cast<unsigned long long>(report.pairs), items.c_str(), report.channels, seconds,
             1e-6 * pairs / std::max(seconds, 1e-9), items.c_str(), report.kernel_seconds);
  text += "; " + std::string(name_of(report.instruction_set)) + ", " +
          std::string(name_of(report.precision)) + ", " + bound_text(report.error_bound);
  if (report.retries > 0) text += "; " + std::to_string(report.retries) + " retries";
  return text;
}

void print_summary(const client::Report& report, const std::string& items, double seconds,
                   bool quiet, bool verbose) {
  const std::string flags = flag_summary(report, items);
  if (!flags.empty() && !quiet) print_note(flags);
  const std::string holes = hole_summary(report, items);
  if (!holes.empty() && !quiet) print_note(holes);
  if (verbose) print_note(report_line(report, items, seconds));
}

}  // namespace gonio::cli
