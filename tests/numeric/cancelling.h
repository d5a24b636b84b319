// Pairs of vectors whose product is a small part of the products that it sums.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "models/oracle/real.h"

namespace gonio::testing {

struct VectorPairs {
  std::vector<double> a, b;        // all x, then all y, then all z
  std::vector<long double> truth;  // a b
};

// a b and the sum of its terms' sizes. The products of float64 are exact in 113 bits.
struct Terms {
  Quad sum, size;

  Terms(const double (&a)[3], const double (&b)[3]) : sum(0), size(0) {
    for (int i = 0; i < 3; ++i) {
      const Quad term = Quad(a[i]) * b[i];
      sum += term;
      size += term < 0 ? -term : term;
    }
  }
};

// `Number`: what the components are exactly. The sums are from 1e-15 to 1 of the products, evenly
// over the exponents: two of the terms, each two in turn, cancel but for their rounding, and the
// third leaves what is asked for.
template <class Number>
VectorPairs cancelling_pairs(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> component(0.5, 1), exponent(-50, 0);
  const auto rounded = [](Quad x) { return double{static_cast<Number>(x)}; };
  VectorPairs all{std::vector<double>(3 * count), std::vector<double>(3 * count), {}};
  while (all.truth.size() < count) {
    const double a[3] = {rounded(component(random)), -rounded(component(random)),
                         rounded(std::exp2(exponent(random)))};
    double b[3] = {rounded(component(random)), 0, 0};
    b[1] = rounded(-Quad(a[0]) * b[0] / a[1]);
    b[2] = rounded((std::exp2(exponent(random)) - Terms(a, b).sum) / a[2]);
    const Terms terms(a, b);
    if (terms.sum < 1e-15 * terms.size) continue;
    const std::size_t pair = all.truth.size();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t at = (i + pair) % 3 * count + pair;
      all.a[at] = a[i], all.b[at] = b[i];
    }
    all.truth.push_back(static_cast<long double>(terms.sum));
  }
  return all;
}

}  // namespace gonio::testing
