// Elementary functions of packets. errors.h states their errors; tests/numeric/proofs prove them.
#pragma once

#include <numbers>

#include "numeric/packet.h"
#include "numeric/vec.h"

namespace gonio::GONIO_ISA {

// Coefficients c[0] + c[1] x + ... by Horner's rule.
template <class T, int N>
GONIO_INLINE T polynomial(T x, const double (&c)[N]) {
  T sum = T(c[N - 1]);
#pragma GCC unroll 16
  for (int i = N - 2; i >= 0; --i) sum = sum * x + T(c[i]);
  return sum;
}

// The rounded sum and its rounding error (Knuth).
template <Exactness E>
GONIO_INLINE void exact_sum(Double<E> a, Double<E> b, Double<E>& sum, Double<E>& error) {
  sum = a + b;
  const Double<E> of_b = sum - a;
  error = (a - (sum - of_b)) + (b - of_b);
}

// ax bx + ay by + az bz, with a relative error of kExactDotError down to sums of 1e-15 of the
// products (Ogita, Rump & Oishi 2005, "Accurate Sum and Dot Product"). The quick form takes float32
// numbers, whose products are exact.
template <Exactness E>
GONIO_INLINE Double<E> exact_dot(const Vec3<Double<E>>& a, const Vec3<Double<E>>& b) {
  using D = Double<E>;
  D x, y, z, lost = 0;
  if constexpr (E == Exactness::exact) {
    D lost_x, lost_y, lost_z;
    exact_product(a.x, b.x, x, lost_x);
    exact_product(a.y, b.y, y, lost_y);
    exact_product(a.z, b.z, z, lost_z);
    lost = lost_x + lost_y + lost_z;
  } else {
    x = a.x * b.x, y = a.y * b.y, z = a.z * b.z;
  }
  D two, three, lost_two, lost_three;
  exact_sum(x, y, two, lost_two);
  exact_sum(two, z, three, lost_three);
  return three + (lost + lost_two + lost_three);
}

// (w/s) log2(1 + s/c), given a = s + c, for s >= 0, c >= 0 (quick: c > 1e-150, as of float32
// cosines) and w = 0 where s = 0. Errors are kQuickWeightedLog2Error, and kExactWeightedLog2Error
// for s above 1e-100 (below, s^2 loses digits and results go to 0).
//
// With k near log2(a/c) it is k plus the series of 2 artanh(z) / log 2, z = (a - c 2^k) /
// (a + c 2^k), |z| < .201. The numerator is formed as s - c (2^k - 1): for k = 0 it is s itself,
// and nothing cancels. One division serves both quotients.
template <Exactness E>
GONIO_INLINE Double<E> weighted_log2_1p(Double<E> w, Double<E> s, Double<E> c, Double<E> a) {
  using D = Double<E>;
  constexpr double kLog2E = 1.44269504088896341;
  // Minimax in z^2; and Taylor's.
  static constexpr double kQuick[] = {2.885390074497867, 0.9618024151201555, 0.5763775016569772,
                                      0.4394355120717109};
  static constexpr double kExact[] = {kLog2E * 2,      kLog2E * 2 / 3,  kLog2E * 2 / 5,
                                      kLog2E * 2 / 7,  kLog2E * 2 / 9,  kLog2E * 2 / 11,
                                      kLog2E * 2 / 13, kLog2E * 2 / 15, kLog2E * 2 / 17,
                                      kLog2E * 2 / 19, kLog2E * 2 / 21};
  if constexpr (E == Exactness::exact) {
    c = max(c, D(1e-150));
    a = s + c;
  }
  D power, k;
  nearest_power(a, c, power, k);
  const D numerator = s - c * (power - D(1)), denominator = a + c * power;
  const D inverse = D(1) / (denominator * s + D(1e-250));  // the addend keeps 0/0 away
  const D z = numerator * s * inverse, quotient = w * denominator * inverse;
  if constexpr (E == Exactness::exact) {
    return quotient * (k + z * polynomial(z * z, kExact));
  } else {
    return quotient * (k + z * polynomial(z * z, kQuick));
  }
}

// 2^x for x <= 0 as a number in [1, 2] and an integer power of two, so that a factor can be applied
// before the product underflows. x below -255 counts as -255.
struct QuickPower {
  Float number, exponent;
};
GONIO_INLINE QuickPower quick_exp2(Double<Exactness::quick> x) {
  // 2^(m - 1) on [1, 2], minimax before rounding to float.
  static constexpr double kExp2[] = {
      0.5002514095335279,  0.3453396716528393,     0.12266852413489496,   0.02486719921157127,
      0.00671434311378965, -5.816856302982807e-05, 0.00021702277208753714};
  Float k, m;
  split_exponent(x, k, m);
  return {polynomial(m, kExp2), k};
}
// amplitude * 2^x for amplitude < 2^127, to kTimesExp2Error where the result is normal.
GONIO_INLINE Float times_exp2(Float amplitude, QuickPower power) {
  return scale(amplitude * power.number, power.exponent);
}

// amplitude * 2^x in float64, for x <= 0, to kExactTimesExp2Error; 0 for x below -1000.
GONIO_INLINE Double<Exactness::exact> times_exp2(Double<Exactness::exact> amplitude,
                                                 Double<Exactness::exact> x) {
  using D = Double<Exactness::exact>;
  static constexpr double kExp[] = {1,
                                    1,
                                    1.0 / 2,
                                    1.0 / 6,
                                    1.0 / 24,
                                    1.0 / 120,
                                    1.0 / 720,
                                    1.0 / 5040,
                                    1.0 / 40320,
                                    1.0 / 362880,
                                    1.0 / 3628800,
                                    1.0 / 39916800,
                                    1.0 / 479001600,
                                    1.0 / 6227020800};
  const D k = round(max(x, D(-1000)));
  const D r = (max(x, D(-1000)) - k) * 0.693147180559945309;
  const D result = amplitude * scale(polynomial(r, kExp), k);
  return select(D(-1000) < x, result, D(0));
}

// The angle of (x, y) for x, y >= 0, in [0, pi/2]; 0 for (0, 0). The errors are kQuickAngleError
// and kExactAngleError.
//
// The smaller over the larger component is brought within tan(pi/16) of one of the angles 0, pi/8,
// pi/4.
template <Exactness E>
GONIO_INLINE Double<E> first_quadrant_angle(Double<E> y, Double<E> x) {
  using D = Double<E>;
  static constexpr double kQuick[] = {1, -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11};
  static constexpr double kExact[] = {1,        -1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9, -1.0 / 11,
                                      1.0 / 13, -1.0 / 15, 1.0 / 17, -1.0 / 19, 1.0 / 21};
  constexpr double kPi = std::numbers::pi;
  const D small = min(y, x), large = max(max(y, x), D(0x1p-1000));
  const Mask over1 = large * 0.198912367379658 < small;  // tan(pi/16)
  const Mask over3 = large * 0.668178637919299 < small;  // tan(3 pi/16)
  const D t = select(over3, D(1), select(over1, D(0.414213562373095049), D(0)));
  const D base = select(over3, D(kPi / 4), select(over1, D(kPi / 8), D(0)));
  const D z = (small - t * large) / (large + t * small);
  D series;
  if constexpr (E == Exactness::exact) {
    series = polynomial(z * z, kExact);
  } else {
    series = polynomial(z * z, kQuick);
  }
  const D angle = base + z * series;
  return select(x < y, D(kPi / 2) - angle, angle);
}

}  // namespace gonio::GONIO_ISA
