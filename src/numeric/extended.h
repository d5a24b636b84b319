// The number system of truth: scalars of long double, 64 bits of mantissa on x86-64.
//
// Elementary functions, which packets approximate, come from the C library here, with errors in the
// last digit. A model's own template then gives the values that its kernels should give.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "numeric/inline.h"
#include "numeric/vec.h"

namespace gonio {

struct ScalarMask {
  bool m = false;
  explicit operator bool() const { return m; }
  friend ScalarMask operator&(ScalarMask a, ScalarMask b) { return {a.m && b.m}; }
};

struct LongDouble {
  long double v = 0;

  LongDouble() = default;
  // Implicit: formulas mix in numbers.
  // NOLINTNEXTLINE(google-explicit-constructor)
  LongDouble(long double x) : v(x) {}

  friend LongDouble operator+(LongDouble a, LongDouble b) { return a.v + b.v; }
  friend LongDouble operator-(LongDouble a, LongDouble b) { return a.v - b.v; }
  friend LongDouble operator-(LongDouble a) { return -a.v; }
  friend LongDouble operator*(LongDouble a, LongDouble b) { return a.v * b.v; }
  friend LongDouble operator/(LongDouble a, LongDouble b) { return a.v / b.v; }
  friend ScalarMask operator<(LongDouble a, LongDouble b) { return {a.v < b.v}; }
  friend LongDouble select(ScalarMask m, LongDouble a, LongDouble b) { return m.m ? a : b; }
  friend LongDouble min(LongDouble a, LongDouble b) { return b.v < a.v ? b : a; }
  friend LongDouble max(LongDouble a, LongDouble b) { return a.v < b.v ? b : a; }
  friend LongDouble multiply_add(LongDouble a, LongDouble b, LongDouble c) {
    return a.v * b.v + c.v;
  }
  friend LongDouble sum_of_products(LongDouble a, LongDouble b, LongDouble c, LongDouble d) {
    return a.v * b.v + c.v * d.v;
  }
  friend LongDouble sqrt(LongDouble a) { return std::sqrt(a.v); }
  friend LongDouble exp2(LongDouble a) { return std::exp2(a.v); }
  friend LongDouble floor(LongDouble a) { return std::floor(a.v); }
  friend LongDouble first_quadrant_angle(LongDouble y, LongDouble x) {
    return std::atan2(y.v, x.v);
  }
  friend float gather(const float* table, LongDouble i) {
    return table[static_cast<std::ptrdiff_t>(i.v)];
  }
};

// The product and its rounding error (Veltkamp & Dekker).
GONIO_INLINE void exact_product(long double a, long double b, long double& product,
                                long double& error) {
  const auto high = [](long double x) {
    const long double scaled = 0x1.00000001p32L * x;
    return scaled - (scaled - x);
  };
  product = a * b;
  const long double ah = high(a), bh = high(b), al = a - ah, bl = b - bh;
  error = al * bl - (((product - ah * bh) - al * bh) - ah * bl);
}

// Ogita, Rump & Oishi's product of two vectors, as in elementary.h.
inline long double exact_dot(const Vec3<LongDouble>& a, const Vec3<LongDouble>& b) {
  const long double p[3] = {a.x.v, a.y.v, a.z.v}, q[3] = {b.x.v, b.y.v, b.z.v};
  long double sum = 0, lost = 0;
  for (int i = 0; i < 3; ++i) {
    long double product = 0, error = 0;
    exact_product(p[i], q[i], product, error);
    const long double next = sum + product, of_product = next - sum;
    lost += error + ((sum - (next - of_product)) + (product - of_product));
    sum = next;
  }
  return sum + lost;
}

struct Extended {
  using WideScalar = LongDouble;
  using RealScalar = LongDouble;
  using Wide = LongDouble;
  using Real = LongDouble;
  using Mask = ScalarMask;
  using Out = long double;
  using Power = LongDouble;  // x
  static constexpr bool kQuick = false;

  // That of double, to which every precision limits its results.
  static LongDouble largest() { return 1.7976931348623157e308L; }
  static LongDouble real(LongDouble w) { return w; }
  static LongDouble root(LongDouble w) { return sqrt(w); }
  static LongDouble inverse_length(LongDouble e) { return 1 / std::sqrt(1 + e.v); }
  static LongDouble exact_dot(const Vec3<LongDouble>& a, const Vec3<LongDouble>& b) {
    return gonio::exact_dot(a, b);
  }
  static LongDouble weighted_log2_1p(LongDouble w, LongDouble s, LongDouble c, LongDouble) {
    constexpr long double kLog2E = 1.44269504088896340735992468100189214L;
    if (!(s.v > 0)) return 0;
    return w.v / s.v * std::log1p(s.v / std::max(c.v, 1e-4900L)) * kLog2E;
  }
  static LongDouble angle(LongDouble y, LongDouble x) { return std::atan2(y.v, x.v); }
  static Power exp2(LongDouble x) { return x; }
  static LongDouble times_exp2(LongDouble a, Power x) { return a.v * std::exp2(x.v); }
};

}  // namespace gonio
