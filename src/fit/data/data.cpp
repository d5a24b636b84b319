#include "fit/data/data.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "fit/data/unit.h"
#include "numeric/direction.h"

namespace gonio::fit {
namespace {

constexpr double kAllPairs = 4 * std::numbers::pi * std::numbers::pi;  // sr^2
constexpr double kUnitTolerance = 1e-3;                                // as evaluation has it

double length(const Direction& w) { return std::hypot(w[0], w[1], w[2]); }

bool all_finite(std::span<const double> numbers) {
  for (const double x : numbers) {
    if (!std::isfinite(static_cast<float>(x))) return false;
  }
  return true;
}

// Counts the entry, and says so, if it is to be left out.
bool leave_out(const Direction& wi, const Direction& wo, std::span<const double> values,
               double weight, LeftOut& left_out) {
  std::size_t* reason = nullptr;
  if (!all_finite(wi) || !all_finite(wo) || !all_finite(values) || !std::isfinite(weight)) {
    reason = &left_out.not_finite;
  } else if (std::abs(length(wi) - 1) > kUnitTolerance ||
             std::abs(length(wo) - 1) > kUnitTolerance) {
    reason = &left_out.not_unit;
  } else if (!(static_cast<float>(wi[2]) > 0) || !(static_cast<float>(wo[2]) > 0)) {
    reason = &left_out.below_horizon;
  } else {
    for (const double v : values) {
      if (v < 0) reason = &left_out.negative;
    }
    if (reason == nullptr && !(weight > 0)) reason = &left_out.no_weight;
  }
  if (reason != nullptr) ++*reason;
  return reason != nullptr;
}

void push(std::array<std::vector<float>, 3>& to, const Direction& w) {
  const double scale = 1 / length(w);
  for (std::size_t k = 0; k < 3; ++k) to[k].push_back(static_cast<float>(w[k] * scale));
}

Outcome check_lengths(std::size_t wi, std::size_t wo, std::size_t values, int channels,
                      std::size_t weights) {
  if (channels < 1 || channels > kMaxChannels)
    return bad_value("channels", std::to_string(channels), "1 to " + std::to_string(kMaxChannels));
  if (wi % 3 != 0) return bad_value("wi", std::to_string(wi) + " numbers", "three a pair");
  const auto check = [](const char* name, std::size_t found, std::size_t expected) -> Outcome {
    if (found == expected) return Ok{};
    return bad_value(name, std::to_string(found) + " numbers", std::to_string(expected));
  };
  if (auto ok = check("wo", wo, wi); !ok) return ok;
  if (auto ok = check("values", values, wi / 3 * static_cast<std::size_t>(channels)); !ok)
    return ok;
  return weights == 0 ? Outcome(Ok{}) : check("weights", weights, wi / 3);
}

// Steele, Lea & Flood 2014, "Fast splittable pseudorandom number generators": splitmix64.
std::uint64_t hash(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

}  // namespace

Result<Data> from_pairs(std::span<const double> wi, std::span<const double> wo,
                        std::span<const double> values, int channels,
                        std::span<const double> weights) {
  auto lengths = check_lengths(wi.size(), wo.size(), values.size(), channels, weights.size());
  if (!lengths) return lengths.error();
  const std::size_t pairs = wi.size() / 3;
  const auto count = static_cast<std::size_t>(channels);
  const double equal = kAllPairs / static_cast<double>(pairs);
  double largest = 0;
  Data data;
  data.channels = channels;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < pairs; ++i) {
    const Direction in = nth_direction(wi, i), out = nth_direction(wo, i);
    const double weight = weights.empty() ? equal : weights[i];
    if (leave_out(in, out, values.subspan(i * count, count), weight, data.left_out)) continue;
    push(data.wi, in);
    push(data.wo, out);
    data.weights.push_back(static_cast<float>(weight));
    kept.push_back(i);
    for (const double value : values.subspan(i * count, count)) largest = std::max(largest, value);
  }
  if (auto ok = check_size(largest); !ok) return ok.error();
  for (std::size_t c = 0; c < count; ++c) {
    for (const std::size_t i : kept)
      data.values.push_back(static_cast<float>(values[i * count + c]));
  }
  return data;
}

Data pick(const Data& data, std::span<const std::size_t> kept, double factor) {
  Data result;
  result.channels = data.channels;
  result.left_out = data.left_out;
  const auto copy = [&](std::span<const float> from, std::vector<float>& to) {
    to.reserve(to.size() + kept.size());
    for (const std::size_t i : kept) to.push_back(from[i]);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    copy(data.wi[k], result.wi[k]);
    copy(data.wo[k], result.wo[k]);
  }
  copy(data.weights, result.weights);
  for (float& w : result.weights) w = static_cast<float>(static_cast<double>(w) * factor);
  result.values.reserve(kept.size() * static_cast<std::size_t>(data.channels));
  for (int c = 0; c < data.channels; ++c) copy(data.channel(c), result.values);
  return result;
}

Data within(const Data& data, double min_theta, double max_theta) {
  const double most = std::cos(min_theta), least = std::cos(max_theta);
  const bool all_above = min_theta <= 0;  // a float cosine may round to 1
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const auto cosine = static_cast<double>(std::min(data.wi[2][i], data.wo[2][i]));
    if (cosine >= least && (all_above || cosine < most)) kept.push_back(i);
  }
  return pick(data, kept, 1);
}

Data subset(const Data& data, std::size_t count, std::uint64_t seed) {
  if (data.size() <= count) return data;
  std::vector<std::size_t> kept;
  kept.reserve(count);
  for (std::size_t run = 0; run < count; ++run) {
    const std::size_t begin = run * data.size() / count, end = (run + 1) * data.size() / count;
    kept.push_back(begin + hash(seed + run) % (end - begin));
  }
  return pick(data, kept, static_cast<double>(data.size()) / static_cast<double>(count));
}

}  // namespace gonio::fit
