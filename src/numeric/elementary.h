// Elementary functions of packets, with their errors. tests/numeric holds each to its statement.
#pragma once

#include "numeric/packet.h"

namespace gonio::GONIO_ISA {

// Coefficients c[0] + c[1] x + ... by Horner's rule.
template <class T, int N>
GONIO_INLINE T polynomial(T x, const double (&c)[N]) {
  T sum = T(c[N - 1]);
#pragma GCC unroll 16
  for (int i = N - 2; i >= 0; --i) sum = sum * x + T(c[i]);
  return sum;
}

// log(1 + s/c) / s for s >= 0, c > 0 normal; 1/c in the limit s = 0. Relative error 4e-12 (quick), 1e-15 (exact).
//
// With k chosen so that (c + s) / (c 2^k) lies in [1/sqrt2, sqrt2], the logarithm is k log 2 plus the series of
// 2 artanh z, z = (c + s - c 2^k) / (c + s + c 2^k). For k = 0 the numerator is s itself: nothing cancels.
template <Exactness E>
GONIO_INLINE Double<E> log1p_over(Double<E> s, Double<E> c) {
  using D = Double<E>;
  static constexpr double kQuick[] = {2, 2.0 / 3, 2.0 / 5, 2.0 / 7, 2.0 / 9, 2.0 / 11, 2.0 / 13};
  static constexpr double kExact[] = {2,        2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9, 2.0 / 11,
                                      2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
  constexpr double kSqrt2 = 1.41421356237309505, kLog2 = 0.693147180559945309;
  const D a = c + s;
  const D k = max(exponent(a * kSqrt2 * reciprocal_estimate(c)), D(0));
  const D b = scale(c, k);
  const Mask reduced = D(0.5) < k;
  const D inverse = D(1) / (a + b);
  const D z = select(reduced, a - b, s) * inverse;
  D series;
  if constexpr (E == Exactness::exact) {
    series = polynomial(z * z, kExact);
  } else {
    series = polynomial(z * z, kQuick);
  }
  const D far = (k * kLog2 + z * series) / max(s, D(0x1p-1000));
  return select(reduced, far, series * inverse);
}

// The parts of e^x = m 2^k with |log m| <= log(2)/2: k and r = log m.
template <Exactness E>
GONIO_INLINE void reduce_exp(Double<E> x, Double<E>& k, Double<E>& r) {
  k = round(x * 1.44269504088896341);
  r = (x - k * 0.693147180369123816490) - k * 1.90821492927058770002e-10;
}

// amplitude * e^x for x <= 0 and finite amplitude, without underflow before the product. Relative error 2e-7.
GONIO_INLINE Float times_exp(Float amplitude, Double<Exactness::quick> x) {
  // Minimax on [-log(2)/2, log(2)/2]; relative error 3.1e-9 before rounding to float.
  static constexpr double kExp[] = {1, 1, 0.4999999344775907, 0.16666520631336332,
                                    0.04166838805202262, 0.008368716919949275, 0.0013814598410815057};
  Double<Exactness::quick> k, r;
  reduce_exp(max(x, Double<Exactness::quick>(-200)), k, r);
  const Float whole = narrow(k);
  const Float half = narrow(round(k * 0.5));
  const Float mantissa = amplitude * polynomial(narrow(r), kExp);
  return scale(scale(mantissa, half), whole - half);
}

// The same in float64. Relative error 5e-16 (1 + |x|).
GONIO_INLINE Double<Exactness::exact> times_exp(Double<Exactness::exact> amplitude, Double<Exactness::exact> x) {
  using D = Double<Exactness::exact>;
  static constexpr double kExp[] = {1,           1,           1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,       1.0 / 720,
                                    1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  D k, r;
  reduce_exp(max(x, D(-700)), k, r);
  const D result = amplitude * scale(polynomial(r, kExp), k);
  return select(D(-700) < x, result, D(0));
}

// The angle of (x, y) for x, y >= 0, in [0, pi/2]; 0 for (0, 0). Error 1e-10 (quick), 3e-16 (exact).
//
// The smaller over the larger component is brought within tan(pi/16) of one of the angles 0, pi/8, pi/4.
template <Exactness E>
GONIO_INLINE Double<E> first_quadrant_angle(Double<E> y, Double<E> x) {
  using D = Double<E>;
  static constexpr double kQuick[] = {1, -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11};
  static constexpr double kExact[] = {1,         -1.0 / 3, 1.0 / 5,   -1.0 / 7, 1.0 / 9,  -1.0 / 11,
                                      1.0 / 13, -1.0 / 15, 1.0 / 17, -1.0 / 19, 1.0 / 21};
  constexpr double kPi = 3.14159265358979323846;
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
