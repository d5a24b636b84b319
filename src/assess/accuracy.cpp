#include "assess/accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assess/places.h"

namespace gonio::assess {
namespace {

constexpr std::size_t kChunk = 2048;  // pairs at a time

// Truth of pairs, pair by pair, channel by channel.
struct Truths {
  std::vector<long double> f, scale;
  std::vector<double> unsure;  // of a relative error, not the material's part; empty: nothing
};

// What four roundings of the parameters move f by, relative to its scale, where that is more than
// roundings in proportion.
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

// Whether the bounds speak of a pair: not nearer to the horizon than they reach.
bool is_within(const Pair& pair, const ErrorBound& bound) {
  const double least = std::min(pair.wi[2], pair.wo[2]);
  return least <= 0 || least > 1.001 * bound.cosine;
}

void keep_worse(Worst& worst, const Worst& found) {
  if (found.error > worst.error) worst = found;
}

// Values of one precision against truth.
class Judge {
 public:
  Judge(std::span<const Pair> pairs, const Truths& truths, const ErrorBound& bound, double largest)
      : pairs_(pairs), truths_(truths), bound_(bound), largest_(largest) {}

  void judge(std::span<const double> values, Findings& findings) const {
    const std::size_t channels = values.size() / pairs_.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (is_proper(values[i], findings) && is_within(pairs_[i / channels], bound_))
        compare(values[i], i, channels, findings);
    }
  }

  // Adds all errors to a list.
  void list(std::span<const double> values, ErrorList& list) const {
    const std::size_t channels = values.size() / pairs_.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Pair& pair = pairs_[i / channels];
      if (!is_within(pair, bound_) || !(std::min(pair.wi[2], pair.wo[2]) > 0)) continue;
      Findings one;
      if (!is_proper(values[i], one)) {
        ++list.improper;
        continue;
      }
      compare(values[i], i, channels, one);
      if (one.checked > 0) list.relative.push_back(one.worst.error);
    }
  }

  // Against the values of the exchanged directions.
  void judge_reciprocity(std::span<const double> values, std::span<const double> exchanged,
                         Worst& worst) const {
    const std::size_t channels = values.size() / pairs_.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double larger = std::max(values[i], exchanged[i]);
      const bool speaks = truths_.scale[i] > 10 * bound_.above && larger < largest_ &&
                          is_within(pairs_[i / channels], bound_);
      if (!speaks || !(larger > 0)) continue;
      // Of a table, as its bounds are: relative to its cells.
      const double size = std::max(larger, static_cast<double>(truths_.scale[i]));
      const double error = std::abs(values[i] - exchanged[i]) / size - 2 * unsure(i);
      keep_worse(worst, {error, pairs_[i / channels], static_cast<int>(i % channels), values[i],
                         exchanged[i]});
    }
  }

 private:
  static bool is_proper(double value, Findings& findings) {
    findings.nan += std::isnan(value) ? 1 : 0;
    findings.infinite += std::isinf(value) ? 1 : 0;
    findings.negative += value < 0 && !std::isinf(value) ? 1 : 0;
    return std::isfinite(value) && value >= 0;
  }

  [[nodiscard]] double unsure(std::size_t i) const {
    return truths_.unsure.empty() ? 0 : truths_.unsure[i];
  }

  void compare(double value, std::size_t i, std::size_t channels, Findings& findings) const {
    const long double truth = truths_.f[i], scale = truths_.scale[i];
    if (scale <= bound_.above) {
      findings.stray += value > 1.001 * bound_.above ? 1 : 0;
      return;
    }
    if (!(scale < largest_)) return;  // beyond the number type, or NaN: not known
    ++findings.checked;
    const auto error = static_cast<double>(std::abs(value - truth) / scale);
    keep_worse(findings.worst, {std::max(0.0, error - unsure(i)), pairs_[i / channels],
                                static_cast<int>(i % channels), value, static_cast<double>(truth)});
  }

  std::span<const Pair> pairs_;
  const Truths& truths_;
  const ErrorBound& bound_;
  double largest_;
};

template <class T>
std::vector<double> naive_values(const NaiveMaterial<T>& naive, std::span<const Pair> pairs,
                                 std::size_t channels) {
  std::vector<double> values;
  values.reserve(pairs.size() * channels);
  std::vector<T> f(channels);
  const auto given = [](const std::array<double, 3>& w) {
    return std::array<T, 3>{static_cast<T>(w[0]), static_cast<T>(w[1]), static_cast<T>(w[2])};
  };
  for (const Pair& pair : pairs) {
    naive.evaluate(given(pair.wi), given(pair.wo), f);
    values.insert(values.end(), f.begin(), f.end());
  }
  return values;
}

template <class T>
void judge_naive(const std::optional<NaiveMaterial<T>>& naive, std::span<const Pair> pairs,
                 std::size_t channels, const Judge& judge, std::optional<Findings>& findings) {
  if (!naive) return;
  if (!findings) findings.emplace();
  judge.judge(naive_values(*naive, pairs, channels), *findings);
}

std::vector<Pair> exchanged(std::vector<Pair> pairs) {
  for (Pair& pair : pairs) std::swap(pair.wi, pair.wo);
  return pairs;
}

void look(const Subject& subject, const std::vector<Pair>& pairs, PlaceReport& report) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  const std::vector<Pair> floats = rounded(pairs);
  const Truths of_floats = truths_of(subject, floats, Precision::fast);
  const Judge judge(floats, of_floats, subject.fast, std::numeric_limits<float>::max());
  const auto values = subject.evaluate(floats, Precision::fast);
  judge.judge(values, report.fast);
  judge.judge_reciprocity(values, subject.evaluate(exchanged(floats), Precision::fast),
                          report.reciprocity);
  judge_naive(subject.naive32, floats, channels, judge, report.naive32);
  judge_naive(subject.naive64, floats, channels, judge, report.naive64);
  const Truths truths = truths_of(subject, pairs, Precision::reference);
  Judge(pairs, truths, subject.reference, std::numeric_limits<double>::max())
      .judge(subject.evaluate(pairs, Precision::reference), report.reference);
  report.pairs += pairs.size();
}

void list_errors(const Subject& subject, const std::vector<Pair>& pairs, PlaceErrors& errors) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  const std::vector<Pair> floats = rounded(pairs);
  const Truths of_floats = truths_of(subject, floats, Precision::fast);
  const Judge judge(floats, of_floats, subject.fast, std::numeric_limits<float>::max());
  judge.list(subject.evaluate(floats, Precision::fast), errors.fast);
  if (subject.naive32) judge.list(naive_values(*subject.naive32, floats, channels), errors.naive32);
  if (subject.naive64) judge.list(naive_values(*subject.naive64, floats, channels), errors.naive64);
  const Truths truths = truths_of(subject, pairs, Precision::reference);
  Judge(pairs, truths, subject.reference, std::numeric_limits<double>::max())
      .list(subject.evaluate(pairs, Precision::reference), errors.reference);
}

}  // namespace

void add_errors_at(std::size_t place, const Subject& subject, std::size_t count, std::uint64_t seed,
                   PlaceErrors& errors) {
  for (std::size_t done = 0; done < count; done += kChunk) {
    const auto pairs =
        pairs_at(place, subject, std::min(kChunk, count - done), seed * 65537 + done);
    if (!pairs.empty()) list_errors(subject, pairs, errors);
  }
}

std::optional<PlaceReport> look_at(std::size_t place, const Subject& subject, std::size_t count,
                                   std::uint64_t seed, const std::function<bool()>& stop) {
  const Place& at = places()[place];
  PlaceReport report;
  report.name = at.name, report.where = at.where, report.failure = at.failure;
  for (std::size_t done = 0; done < count; done += kChunk) {
    if (stop && stop()) return std::nullopt;
    const auto pairs =
        pairs_at(place, subject, std::min(kChunk, count - done), seed * 65537 + done);
    if (pairs.empty()) return std::nullopt;
    look(subject, pairs, report);
  }
  return report;
}

}  // namespace gonio::assess
