// Errors that are ratios of sums over pairs, with confidence intervals.
//
// Pairs are drawn independently and stand in blocks; the standard error of a ratio, or of the
// difference of two that were formed on the same blocks, is the delete-one-block jackknife's
// (Efron & Stein 1981), and intervals are Student's with one degree of freedom less than blocks.
#pragma once

#include <span>

namespace gonio::select {

// What one block adds to a ratio of sums.
struct Ratio {
  double numerator = 0, denominator = 0;
};

struct Estimate {
  double value = 0, standard_error = 0;
};

Estimate estimate(std::span<const Ratio> blocks);
// Of a - b; both over the same blocks.
Estimate estimate_difference(std::span<const Ratio> a, std::span<const Ratio> b);

// The quantile of Student's distribution for 0 < p < 1. Within 1e-3 of its value for 7 degrees and
// p from 0.001 to 0.999, closer for more (Abramowitz & Stegun 1964, 26.7.5).
double student_quantile(double p, double degrees);

}  // namespace gonio::select
