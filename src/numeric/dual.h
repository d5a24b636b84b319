// Dual numbers: a value and its derivative along one direction in the space of parameters (Clifford
// 1873; forward differentiation). T is double for a material's constants, a packet in kernels.
//
// min, max and select follow the value, so that derivatives are one-sided where a formula has a
// corner; a square root has derivative 0 where it is 0, which keeps derivatives finite there.
#pragma once

#include <cmath>
#include <type_traits>

#include "numeric/inline.h"

namespace gonio {

template <class T>
struct Dual {
  T v = 0, d = 0;

  GONIO_INLINE Dual() = default;
  // Implicit: formulas mix in numbers.
  // NOLINTNEXTLINE(google-explicit-constructor)
  GONIO_INLINE Dual(double x) : v(x) {}
  GONIO_INLINE Dual(T value, T derivative) : v(value), d(derivative) {}
  // A material's constant, in all lanes of a packet.
  template <class Number>
  requires(!std::is_same_v<Number, T>) explicit GONIO_INLINE Dual(const Dual<Number>& x)
      : v(x.v), d(x.d) {}

  // A number that depends on no parameter.
  static GONIO_INLINE Dual constant(T x) { return Dual(x, T(0)); }
  template <class Number>
  static GONIO_INLINE Dual load(const Number* p) {
    return constant(T::load(p));
  }
  // A kernel stores the derivative.
  template <class Number>
  GONIO_INLINE void store(Number* p) const {
    d.store(p);
  }

  friend GONIO_INLINE Dual operator+(const Dual& a, const Dual& b) {
    return {a.v + b.v, a.d + b.d};
  }
  friend GONIO_INLINE Dual operator-(const Dual& a, const Dual& b) {
    return {a.v - b.v, a.d - b.d};
  }
  friend GONIO_INLINE Dual operator-(const Dual& a) { return {-a.v, -a.d}; }
  friend GONIO_INLINE Dual operator*(const Dual& a, const Dual& b) {
    return {a.v * b.v, a.d * b.v + a.v * b.d};
  }
  friend GONIO_INLINE Dual operator/(const Dual& a, const Dual& b) {
    const T quotient = a.v / b.v;
    return {quotient, (a.d - quotient * b.d) / b.v};
  }
  friend GONIO_INLINE auto operator<(const Dual& a, const Dual& b) { return a.v < b.v; }
  template <class Mask>
  friend GONIO_INLINE Dual select(const Mask& m, const Dual& a, const Dual& b) {
    return {select(m, a.v, b.v), select(m, a.d, b.d)};
  }
  friend GONIO_INLINE Dual min(const Dual& a, const Dual& b) { return select(b.v < a.v, b, a); }
  friend GONIO_INLINE Dual max(const Dual& a, const Dual& b) { return select(a.v < b.v, b, a); }
  // a b + p, and a b + p q.
  friend GONIO_INLINE Dual multiply_add(const Dual& a, const Dual& b, const Dual& p) {
    return {multiply_add(a.v, b.v, p.v), sum_of_products(a.d, b.v, a.v, b.d) + p.d};
  }
  friend GONIO_INLINE Dual sum_of_products(const Dual& a, const Dual& b, const Dual& p,
                                           const Dual& q) {
    return {sum_of_products(a.v, b.v, p.v, q.v),
            sum_of_products(a.d, b.v, a.v, b.d) + sum_of_products(p.d, q.v, p.v, q.d)};
  }
  friend GONIO_INLINE Dual sqrt(const Dual& a) {
    using std::sqrt;
    const T root = sqrt(a.v);
    if constexpr (std::is_same_v<T, double>) {
      return {root, root > 0 ? a.d / (2 * root) : 0};
    } else {
      const T half_inverse = T(0.5) / max(root, T(1e-300));
      return {root, select(T(0) < root, a.d * half_inverse, T(0))};
    }
  }
};

// 2^x of a material's constants.
inline Dual<double> exp2(const Dual<double>& x) {
  const double power = std::exp2(x.v);
  return {power, 0.693147180559945309 * power * x.d};
}

}  // namespace gonio
