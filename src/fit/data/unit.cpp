#include "fit/data/unit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace gonio::fit {
namespace {

constexpr int kLeastOrdinary = -10, kMostOrdinary = 6;  // exponents of the mean
constexpr int kMean = -4;                               // of the mean in another unit
constexpr int kMostValue = 100;                         // of the largest value, in that unit

double largest_of(const Data& data) {
  float largest = 0;
  for (const float value : data.values) largest = std::max(largest, value);
  return static_cast<double>(largest);
}

}  // namespace

double mean_of(const Data& data, bool cosine) {
  double sum = 0, weights = 0;
  for (int c = 0; c < data.channels; ++c) {
    const auto values = data.channel(c);
    for (std::size_t i = 0; i < data.size(); ++i) {
      const auto w = static_cast<double>(data.weights[i]);
      sum +=
          w * static_cast<double>(values[i]) * (cosine ? static_cast<double>(data.wi[2][i]) : 1.0);
      weights += w;
    }
  }
  return weights > 0 ? sum / weights : 0;
}

double unit_of(const Data& data, bool cosine) {
  const double mean = mean_of(data, cosine);
  if (!(mean > 0)) return 1;
  const int size = std::ilogb(mean);
  if (size >= kLeastOrdinary && size < kMostOrdinary) return 1;
  // One value far above all others, with next to no weight, must stay finite.
  return std::ldexp(1.0, std::max(size - kMean, std::ilogb(largest_of(data)) - kMostValue));
}

Data in_unit(Data data, double unit) {
  for (float& value : data.values) value = static_cast<float>(static_cast<double>(value) / unit);
  return data;
}

Outcome check_size(const Data& data) { return check_size(largest_of(data)); }

Outcome check_size(double largest) {
  constexpr auto kLeast = static_cast<double>(std::numeric_limits<float>::min());
  if (!(largest > 0) || largest >= kLeast) return Ok{};
  char found[48];
  std::snprintf(found, sizeof found, "at most %.3g", largest);
  return bad_value(
      "values", found,
      "0, or at least one of 1.18e-38 and more, from where float32 has all its digits");
}

}  // namespace gonio::fit
