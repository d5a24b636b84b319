// Compares values with truth. Internal to accuracy.cpp. Thread safety: plain values, functions
// without state.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "assess/accuracy.h"
#include "assess/report.h"
#include "assess/subject.h"

namespace gonio::assess {

// Truth of pairs, pair by pair, channel by channel.
struct Truths {
  std::vector<long double> f, scale;
  std::vector<double>
      unsure;  // the part of a relative error that is not the material's fault; empty: none
};

Truths truths_of(const Subject& subject, std::span<const Pair> pairs, Precision precision);

// Compares values of one precision with truth. Its arguments must outlive it.
class ValueComparison {
 public:
  ValueComparison(std::span<const Pair> pairs, const Truths& truths, const ErrorBound& bound,
                  double largest)
      : pairs_(pairs), truths_(truths), bound_(bound), largest_(largest) {}

  void check(std::span<const double> values, Findings& findings) const;
  // Adds all errors to a list.
  void list(std::span<const double> values, ErrorList& errors) const;
  // Compares with the values of the exchanged directions.
  void check_reciprocity(std::span<const double> values, std::span<const double> exchanged,
                         Worst& worst) const;

 private:
  [[nodiscard]] double unsure(std::size_t i) const {
    return truths_.unsure.empty() ? 0 : truths_.unsure[i];
  }
  void compare(double value, std::size_t i, std::size_t channels, Findings& findings) const;

  std::span<const Pair> pairs_;
  const Truths& truths_;
  const ErrorBound& bound_;
  double largest_;
};

}  // namespace gonio::assess
