// Holds results against truth: relative errors where they mean something, and nothing improper
// anywhere.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "models/oracle/real.h"

namespace gonio::testing {

inline std::string text(Quad v) {
  std::array<char, 64> buffer{};
  quadmath_snprintf(buffer.data(), buffer.size(), "%.20Qg", v);
  return buffer.data();
}

struct Comparison {
  std::size_t checked = 0;   // values where truth is in the range of the relative criterion
  double worst = 0;          // relative error there
  std::size_t worst_at = 0;  // index of the value
  double p999 = 0;           // the error that 99.9 % stay below
  std::optional<std::size_t> improper_at;  // the first value that no criterion allows
  std::string improper;                    // and why
};

// What is wrong with a value whatever the accuracy, or empty. `above` is where the relative
// criterion begins; below it a value must be as small as truth is. A truth of NaN asks only for a
// proper value.
template <class Out>
std::string improper(Out got, Quad truth, double above) {
  constexpr Out kLargest = std::numeric_limits<Out>::max();
  if (std::isnan(got)) return "NaN";
  if (std::isinf(got)) return "infinite";
  if (std::signbit(got)) return "negative";
  if (truth <= above && static_cast<double>(got) > above * 1.001) return "not small where f is";
  if (truth > kLargest && got != kLargest) return "not saturated where f is beyond the range";
  return {};
}

// `unsure` is, for each value, the part of the relative error that is not the library's; may be
// empty.
template <class Out>
Comparison compare(std::span<const Out> got, std::span<const Quad> truth, double above,
                   std::span<const double> unsure = {}) {
  Comparison result;
  std::vector<double> errors;
  errors.reserve(got.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (std::string why = improper(got[i], truth[i], above); !why.empty()) {
      if (!result.improper_at) result.improper_at = i, result.improper = std::move(why);
      continue;
    }
    if (!(truth[i] > above) || truth[i] > std::numeric_limits<Out>::max()) continue;
    const Quad difference = static_cast<Quad>(got[i]) - truth[i];
    const auto error = static_cast<double>((difference < 0 ? -difference : difference) / truth[i]);
    errors.push_back(unsure.empty() ? error : std::max(0.0, error - unsure[i]));
    if (errors.back() > result.worst) result.worst = errors.back(), result.worst_at = i;
  }
  result.checked = errors.size();
  if (errors.empty()) return result;
  const auto nth = errors.begin() + static_cast<std::ptrdiff_t>((errors.size() - 1) * 999 / 1000);
  std::nth_element(errors.begin(), nth, errors.end());
  result.p999 = *nth;
  return result;
}

}  // namespace gonio::testing
