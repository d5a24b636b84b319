// Pearson's chi-square test.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace gonio::assess {

// Gamma(a, x) / Gamma(a): the series below a + 1, the continued fraction (Lentz) above.
inline double upper_gamma(double a, double x) {
  const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (double n = a + 1; term > sum * 1e-15; ++n) sum += term *= x / n;
    return 1 - scale * sum;
  }
  double b = x + 1 - a, c = 1e300, d = 1 / b, fraction = d;
  for (int i = 1; i < 10'000; ++i) {
    const double numerator = -i * (i - a);
    b += 2;
    d = 1 / (numerator * d + b);
    c = b + numerator / c;
    fraction *= c * d;
    if (std::abs(c * d - 1) < 1e-14) break;
  }
  return scale * fraction;
}

// The probability of counts at least as far from those expected. Bins with an expected count below
// 5 are merged.
inline double chi_square_probability(const std::vector<double>& expected,
                                     const std::vector<double>& observed) {
  double sum = 0, few_expected = 0, few_observed = 0;
  std::size_t bins = 0;
  const auto add = [&](double want, double got) {
    sum += (got - want) * (got - want) / want;
    ++bins;
  };
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] >= 5) {
      add(expected[i], observed[i]);
    } else {
      few_expected += expected[i], few_observed += observed[i];
    }
  }
  // The merged bins have an expected count of at least 1, so that draws where almost none are
  // expected have a finite weight.
  if (few_observed > 0 || few_expected >= 5) add(std::fmax(few_expected, 1), few_observed);
  if (bins < 2) return 1;
  return sum > 0 ? upper_gamma((static_cast<double>(bins) - 1) / 2, sum / 2) : 1;
}

// The level of each of `tests` independent tests at which all together fail by chance with
// probability `level`.
inline double sidak(double level, std::size_t tests) {
  return -std::expm1(std::log1p(-level) / static_cast<double>(tests));
}

}  // namespace gonio::assess
