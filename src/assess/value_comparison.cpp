#include "assess/value_comparison.h"

#include <algorithm>
#include <cmath>

namespace gonio::assess {
namespace {

// The change of f by four roundings of its parameters, relative to its scale, where it exceeds that
// of a product.
std::vector<double> unsure_of(const Subject& subject, std::span<const Pair> pairs,
                              const Truths& truths, double rounding) {
  if (subject.roundings.empty()) return {};
  const auto channels = static_cast<std::size_t>(subject.channels);
  std::vector<double> unsure(truths.f.size());
  std::vector<long double> moved(channels);
  for (const Truth& truth : subject.roundings) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      truth.evaluate(pairs[i].wi, pairs[i].wo, moved);
      for (std::size_t c = 0; c < channels; ++c) {
        const std::size_t at = i * channels + c;
        if (!(truths.scale[at] > 0)) continue;
        const long double shift = std::abs(moved[c] - truths.f[at]) / truths.scale[at];
        unsure[at] = std::max(unsure[at], static_cast<double>(4 * shift * (rounding / kStep)));
      }
    }
  }
  for (double& shift : unsure) shift = shift > 16 * rounding ? shift : 0;
  return unsure;
}

// Whether the bounds apply to a pair: it is far enough from the horizon.
bool is_within(const Pair& pair, const ErrorBound& bound) {
  const double least = std::min(pair.wi[2], pair.wo[2]);
  return least <= 0 || least > 1.001 * bound.cosine;
}

void keep_worse(Worst& worst, const Worst& found) {
  if (found.error > worst.error) worst = found;
}

bool is_proper(double value, Findings& findings) {
  findings.nan += std::isnan(value) ? 1 : 0;
  findings.infinite += std::isinf(value) ? 1 : 0;
  findings.negative += value < 0 && !std::isinf(value) ? 1 : 0;
  return std::isfinite(value) && value >= 0;
}

}  // namespace

Truths truths_of(const Subject& subject, std::span<const Pair> pairs, Precision precision) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  Truths truths{std::vector<long double>(pairs.size() * channels),
                std::vector<long double>(pairs.size() * channels),
                {}};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    subject.truth.evaluate(pairs[i].wi, pairs[i].wo,
                           std::span(truths.f).subspan(i * channels, channels),
                           std::span(truths.scale).subspan(i * channels, channels));
  }
  truths.unsure =
      unsure_of(subject, pairs, truths, precision == Precision::fast ? 0x1p-24 : 0x1p-52);
  return truths;
}

void ValueComparison::check(std::span<const double> values, Findings& findings) const {
  const std::size_t channels = values.size() / pairs_.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_proper(values[i], findings) && is_within(pairs_[i / channels], bound_))
      compare(values[i], i, channels, findings);
  }
}

void ValueComparison::list(std::span<const double> values, ErrorList& errors) const {
  const std::size_t channels = values.size() / pairs_.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Pair& pair = pairs_[i / channels];
    if (!is_within(pair, bound_) || !(std::min(pair.wi[2], pair.wo[2]) > 0)) continue;
    Findings one;
    if (!is_proper(values[i], one)) {
      ++errors.improper;
      continue;
    }
    compare(values[i], i, channels, one);
    if (one.checked > 0) errors.relative.push_back(one.worst.error);
  }
}

void ValueComparison::check_reciprocity(std::span<const double> values,
                                        std::span<const double> exchanged, Worst& worst) const {
  const std::size_t channels = values.size() / pairs_.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double larger = std::max(values[i], exchanged[i]);
    const bool speaks = truths_.scale[i] > 10 * bound_.above && larger < largest_ &&
                        is_within(pairs_[i / channels], bound_);
    if (!speaks || !(larger > 0)) continue;
    // Relative to the cells of a table, as its bounds are.
    const double size = std::max(larger, static_cast<double>(truths_.scale[i]));
    const double error = std::abs(values[i] - exchanged[i]) / size - 2 * unsure(i);
    const Pair& pair = pairs_[i / channels];
    keep_worse(worst, {error, pair.wi, pair.wo, static_cast<unsigned>(i % channels), values[i],
                       exchanged[i]});
  }
}

void ValueComparison::compare(double value, std::size_t i, std::size_t channels,
                              Findings& findings) const {
  const long double truth = truths_.f[i], scale = truths_.scale[i];
  if (scale <= bound_.above) {
    findings.stray += value > 1.001 * bound_.above ? 1 : 0;
    return;
  }
  if (!(scale < largest_)) return;  // beyond the number type, or NaN: truth is not known
  ++findings.checked;
  const auto error = static_cast<double>(std::abs(value - truth) / scale);
  const Pair& pair = pairs_[i / channels];
  keep_worse(findings.worst,
             {std::max(0.0, error - unsure(i)), pair.wi, pair.wo,
              static_cast<unsigned>(i % channels), value, static_cast<double>(truth)});
}

}  // namespace gonio::assess
