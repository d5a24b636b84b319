#include "select/error/interval.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace gonio::select {
namespace {

double value_of(const Ratio& sum) {
  return sum.denominator > 0 ? sum.numerator / sum.denominator : 0;
}

Ratio total(std::span<const Ratio> blocks) {
  Ratio sum;
  for (const Ratio& block : blocks) {
    sum.numerator += block.numerator;
    sum.denominator += block.denominator;
  }
  return sum;
}

double without(const Ratio& sum, const Ratio& block) {
  return value_of({sum.numerator - block.numerator, sum.denominator - block.denominator});
}

double jackknife_error(std::span<const double> left) {
  const auto n = static_cast<double>(left.size());
  double mean = 0, squares = 0;
  for (const double x : left) mean += x / n;
  for (const double x : left) squares += (x - mean) * (x - mean);
  return std::sqrt(squares * (n - 1) / n);
}

double normal_quantile(double p) {
  double lower = -40, upper = 40;
  for (int i = 0; i < 80; ++i) {
    const double x = 0.5 * (lower + upper);
    (0.5 * std::erfc(-x / std::numbers::sqrt2) < p ? lower : upper) = x;
  }
  return 0.5 * (lower + upper);
}

}  // namespace

Estimate estimate(std::span<const Ratio> blocks) {
  const Ratio sum = total(blocks);
  std::vector<double> left;
  for (const Ratio& block : blocks) left.push_back(without(sum, block));
  return {value_of(sum), jackknife_error(left)};
}

Estimate estimate_difference(std::span<const Ratio> a, std::span<const Ratio> b) {
  const Ratio sum_a = total(a), sum_b = total(b);
  std::vector<double> left;
  for (std::size_t i = 0; i < a.size(); ++i)
    left.push_back(without(sum_a, a[i]) - without(sum_b, b[i]));
  return {value_of(sum_a) - value_of(sum_b), jackknife_error(left)};
}

double student_quantile(double p, double degrees) {
  const double x = normal_quantile(p), x2 = x * x, n = degrees;
  const double g1 = x * (x2 + 1) / 4, g2 = x * ((5 * x2 + 16) * x2 + 3) / 96,
               g3 = x * (((3 * x2 + 19) * x2 + 17) * x2 - 15) / 384,
               g4 = x * ((((79 * x2 + 776) * x2 + 1482) * x2 - 1920) * x2 - 945) / 92160;
  return x + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n;
}

}  // namespace gonio::select
