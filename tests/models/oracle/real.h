// The number types of the oracle and their elementary functions.
//
// Truth is computed with 113 bits: a reference that is right to 3e-11 in a lobe of exponent 1e6, or
// for directions that nearly cancel, cannot be judged with the 64 bits of long double everywhere.
#pragma once

#include <quadmath.h>

#include <cmath>

namespace gonio::testing {

using Quad = __float128;

inline long double root(long double x) { return std::sqrt(x); }
inline long double power(long double x, long double y) { return std::pow(x, y); }
inline long double exponential(long double x) { return std::exp(x); }
inline double root(double x) { return std::sqrt(x); }
inline double power(double x, double y) { return std::pow(x, y); }
inline double exponential(double x) { return std::exp(x); }
inline long double arctangent(long double y, long double x) { return std::atan2(y, x); }
inline Quad arctangent(Quad y, Quad x) { return atan2q(y, x); }
inline long double cosine(long double x) { return std::cos(x); }
inline Quad cosine(Quad x) { return cosq(x); }
inline long double sine(long double x) { return std::sin(x); }
inline Quad sine(Quad x) { return sinq(x); }
inline Quad root(Quad x) { return sqrtq(x); }
inline Quad power(Quad x, Quad y) { return powq(x, y); }
inline Quad exponential(Quad x) { return expq(x); }

template <class Real>
Real pi() {
  static const Real value = static_cast<Real>(acosq(-1));
  return value;
}

}  // namespace gonio::testing
