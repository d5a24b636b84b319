// Elementary functions for drawing samples, in float32 packets or exact float64 ones. Their errors
// are in errors.h, which tests/numeric/proofs prove.
#pragma once

#include <numbers>

#include "numeric/elementary.h"

namespace gonio::GONIO_ISA {

// log2(1 - x) for x in [0, 1], given rest = 1 - x as rounded, with relative errors
// kLog2OneMinusError and kExactLog2OneMinusError; for x = 1 a number below -120.
GONIO_INLINE Float log2_of_rest(Float x, Float rest) {
  // log2(1 + f) / f on [-1/4, 1/2], minimax.
  static constexpr double kLog2[] = {
      1.4426950324423307,  -0.7213484783848707,  0.4809020804770834,
      -0.3605759215928098, 0.28819150539777116,  -0.2427235255458412,
      0.21632486125015776, -0.17423017007821578, 0.07806667083321486};
  rest = max(rest, Float(0x1p-125));
  const Float k = exponent(rest * Float(4. / 3));
  const Float f = select(Float(-0.5) < k, -x, scale(rest, -k) - Float(1));
  return k + f * polynomial(f, kLog2);
}
GONIO_INLINE Double<Exactness::exact> log2_of_rest(Double<Exactness::exact> x,
                                                   Double<Exactness::exact> rest) {
  return -weighted_log2_1p(x, x, rest, Double<Exactness::exact>(1));
}
template <class T>
GONIO_INLINE T log2_one_minus(T x) {
  return log2_of_rest(x, T(1) - x);
}

// 2^x and 1 - 2^x for x <= 0, both with relative errors kExp2Error and kOneMinusExp2Error (in
// float64 kExact...), also where x is nearly 0. In float32 for x > -100.
template <class T>
struct Exp2 {
  T power, one_minus;
};
GONIO_INLINE Exp2<Float> exp2_of(Float x) {
  // (2^r - 1) / r on [-1/2, 1/2], minimax.
  static constexpr double kExp2[] = {0.6931471879266903,    0.24022649794958717,
                                     0.055503574336381034,  0.00961823749498426,
                                     0.0013390735477003118, 0.0001540351236185896};
  const Float bounded = max(x, Float(-125)), k = round(bounded), r = bounded - k;
  const Float power = scale(Float(1), k), change = r * polynomial(r, kExp2);
  return {power + power * change, (Float(1) - power) - power * change};
}
GONIO_INLINE Exp2<Double<Exactness::exact>> exp2_of(Double<Exactness::exact> x) {
  using D = Double<Exactness::exact>;
  // (e^r - 1) / r, Taylor.
  static constexpr double kExp[] = {1,
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
  const D bounded = max(x, D(-1000)), k = round(bounded);
  const D r = (bounded - k) * D(0.693147180559945309);
  const D power = scale(D(1), k), change = r * polynomial(r, kExp);
  return {power + power * change, (D(1) - power) - power * change};
}

// Cosine and sine of an angle, with errors kTurnError or kHalfTurnError; in float64 kExact...
template <class T>
struct Turn {
  T cos, sin;
};
template <class T, int kSine, int kCosine>
GONIO_INLINE Turn<T> half_turn_of(T x, const double (&sine)[kSine],
                                  const double (&cosine)[kCosine]) {
  const T angle = (x - T(0.5)) * T(std::numbers::pi), square = angle * angle;
  return {polynomial(square, cosine), angle * polynomial(square, sine)};
}
// The direction at x half turns from -90 degrees, x in [0, 1).
template <class T>
GONIO_INLINE Turn<T> half_turn(T x) {
  static constexpr double kSine[] = {1,
                                     -1.0 / 6,
                                     1.0 / 120,
                                     -1.0 / 5040,
                                     1.0 / 362880,
                                     -1.0 / 39916800,
                                     1.0 / 6227020800,
                                     -1.0 / 1307674368000,
                                     1.0 / 355687428096000,
                                     -1.0 / 121645100408832000,
                                     1.0 / 51090942171709440000.};
  static constexpr double kCosine[] = {1,
                                       -1.0 / 2,
                                       1.0 / 24,
                                       -1.0 / 720,
                                       1.0 / 40320,
                                       -1.0 / 3628800,
                                       1.0 / 479001600,
                                       -1.0 / 87178291200,
                                       1.0 / 20922789888000,
                                       -1.0 / 6402373705728000,
                                       1.0 / 2432902008176640000,
                                       -1.0 / 1124000727777607680000.};
  return half_turn_of(x, kSine, kCosine);
}
template <>
GONIO_INLINE Turn<Float> half_turn(Float x) {
  // Minimax on [-pi/2, pi/2].
  static constexpr double kSine[] = {0.99999999569880902, -0.16666657947846011,
                                     0.0083330501706717732, -0.00019809017408678004,
                                     2.6051076353347881e-6};
  static constexpr double kCosine[] = {0.99999995302751237, -0.49999904777792114,
                                       0.041663573160188248, -0.001385362953617557,
                                       2.3152416659997793e-5};
  return half_turn_of(x, kSine, kCosine);
}
// The direction at x turns, x in [0, 1), from that of half the angle seen from the opposite side.
template <class T>
GONIO_INLINE Turn<T> turn(T x) {
  const Turn<T> half = half_turn(x);
  return {T(2) * (half.sin * half.sin) - T(1), T(-2) * (half.sin * half.cos)};
}

}  // namespace gonio::GONIO_ISA
