#include "timing/spread.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gonio::timing {
namespace {

// The quantile of sorted numbers, interpolated between neighbours.
double at(const std::vector<double>& sorted, double part) {
  const double position = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

}  // namespace

Spread spread_of(std::span<const double> times) {
  if (times.empty()) return {};
  std::vector<double> sorted(times.begin(), times.end());
  std::ranges::sort(sorted);
  return {sorted.front(), at(sorted, 0.25), at(sorted, 0.5), at(sorted, 0.75),
          static_cast<int>(sorted.size())};
}

Spread scaled(const Spread& spread, double factor) {
  return {spread.best * factor, spread.lower * factor, spread.median * factor,
          spread.upper * factor, spread.repetitions};
}

}  // namespace gonio::timing
