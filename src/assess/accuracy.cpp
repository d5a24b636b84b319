#include "assess/accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assess/places.h"
#include "assess/value_comparison.h"

namespace gonio::assess {
namespace {

constexpr std::size_t kChunk = 2048;  // pairs at a time

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
void compare_naive(const std::optional<NaiveMaterial<T>>& naive, std::span<const Pair> pairs,
                   std::size_t channels, const ValueComparison& comparison,
                   std::optional<Findings>& findings) {
  if (!naive) return;
  if (!findings) findings.emplace();
  comparison.check(naive_values(*naive, pairs, channels), *findings);
}

std::vector<Pair> exchanged(std::vector<Pair> pairs) {
  for (Pair& pair : pairs) std::swap(pair.wi, pair.wo);
  return pairs;
}

void look(const Subject& subject, const std::vector<Pair>& pairs, PlaceReport& report) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  const std::vector<Pair> floats = rounded(pairs);
  const Truths of_floats = truths_of(subject, floats, Precision::fast);
  const ValueComparison comparison(floats, of_floats, subject.fast,
                                   std::numeric_limits<float>::max());
  const auto values = subject.evaluate(floats, Precision::fast);
  comparison.check(values, report.fast);
  comparison.check_reciprocity(values, subject.evaluate(exchanged(floats), Precision::fast),
                               report.reciprocity);
  compare_naive(subject.naive32, floats, channels, comparison, report.naive32);
  compare_naive(subject.naive64, floats, channels, comparison, report.naive64);
  const Truths truths = truths_of(subject, pairs, Precision::reference);
  ValueComparison(pairs, truths, subject.reference, std::numeric_limits<double>::max())
      .check(subject.evaluate(pairs, Precision::reference), report.reference);
  report.pairs += pairs.size();
}

void list_errors(const Subject& subject, const std::vector<Pair>& pairs, PlaceErrors& errors) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  const std::vector<Pair> floats = rounded(pairs);
  const Truths of_floats = truths_of(subject, floats, Precision::fast);
  const ValueComparison comparison(floats, of_floats, subject.fast,
                                   std::numeric_limits<float>::max());
  comparison.list(subject.evaluate(floats, Precision::fast), errors.fast);
  if (subject.naive32)
    comparison.list(naive_values(*subject.naive32, floats, channels), errors.naive32);
  if (subject.naive64)
    comparison.list(naive_values(*subject.naive64, floats, channels), errors.naive64);
  const Truths truths = truths_of(subject, pairs, Precision::reference);
  ValueComparison(pairs, truths, subject.reference, std::numeric_limits<double>::max())
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
  const HardPlace& at = places()[place];
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
