#include "fit/data/outliers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

namespace gonio::fit {
namespace {

constexpr float kFar = 1000;
constexpr std::size_t kFewestPairs = 20;

double degrees_of(float cosine) {
  return std::acos(std::clamp(static_cast<double>(cosine), 0.0, 1.0)) * 180 / std::numbers::pi;
}

std::string sentence(const Data& data, int channel, std::size_t count, std::size_t at, float next) {
  std::array<char, 200> text{};
  const double value = static_cast<double>(data.channel(channel)[at]);
  std::snprintf(text.data(), text.size(),
                "%zu value%s of channel %d %s far out: %.3g 1/sr at theta_i %.3g, theta_o %.3g "
                "degrees, %.2g times the next",
                count, count == 1 ? "" : "s", channel, count == 1 ? "is" : "are", value,
                degrees_of(data.wi[2][at]), degrees_of(data.wo[2][at]),
                value / static_cast<double>(next));
  return text.data();
}

std::string in_channel(const Data& data, int channel) {
  const auto values = data.channel(channel);
  const std::size_t most = std::max<std::size_t>(3, data.size() / 1000);
  std::vector<std::size_t> order(data.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto top = order.begin() + static_cast<std::ptrdiff_t>(most) + 1;
  std::ranges::partial_sort(order, top, std::greater<>(), [&](std::size_t i) { return values[i]; });
  for (std::size_t k = 0; k < most; ++k) {
    const float next = values[order[k + 1]];
    if (!(next > 0)) break;  // of data that are dark but for some values nothing can be said
    if (values[order[k]] > kFar * next) return sentence(data, channel, k + 1, order[0], next);
  }
  return {};
}

}  // namespace

std::string outliers_of(const Data& data) {
  if (data.size() < kFewestPairs) return {};
  std::string all;
  for (int c = 0; c < data.channels; ++c) {
    const std::string one = in_channel(data, c);
    if (!one.empty()) all += (all.empty() ? "" : "; ") + one;
  }
  return all;
}

void judge_outliers(const Data& data, Certificate& certificate) {
  const std::string found = outliers_of(data);
  if (found.empty()) return;
  if (certificate.objective != Objective::log && certificate.verdict == Verdict::converged)
    certificate.verdict = Verdict::failed;
  certificate.reason =
      found + ": the fit follows that and says nothing of the rest; " + certificate.reason;
}

}  // namespace gonio::fit
