// The number system of derivatives: Reference with dual numbers in the place of numbers.
//
// Directions are given and depend on no parameter; only the constants do.
#pragma once

#include "numeric/dual.h"
#include "numeric/number.h"

namespace gonio::GONIO_ISA {

struct Derivative {
  using Number = Reference::Wide;
  using WideScalar = Dual<double>;
  using RealScalar = Dual<double>;
  using Wide = Dual<Number>;
  using Real = Wide;
  using Mask = GONIO_ISA::Mask;
  using Out = double;
  using Power = Wide;
  static constexpr bool kQuick = false;

  static GONIO_INLINE Real largest() { return Real::constant(Reference::largest()); }
  static GONIO_INLINE Real real(const Wide& w) { return w; }
  static GONIO_INLINE Real root(const Wide& w) { return sqrt(w); }
  static GONIO_INLINE Wide inverse_length(const Wide& e) {
    return Wide::constant(Reference::inverse_length(e.v));
  }
  static GONIO_INLINE Wide exact_dot(const Vec3<Wide>& a, const Vec3<Wide>& b) {
    return Wide::constant(Reference::exact_dot({a.x.v, a.y.v, a.z.v}, {b.x.v, b.y.v, b.z.v}));
  }
  static GONIO_INLINE Wide angle(const Wide& y, const Wide& x) {
    return Wide::constant(Reference::angle(y.v, x.v));
  }

  // With L = (w/s) log2(1 + s/c): dL = dw L/w + (w/s) dlog2(1 + s/c) - L ds/s. Where s = 0, so is w
  // and all of it.
  static GONIO_INLINE Wide weighted_log2_1p(const Wide& w, const Wide& s, const Wide& c,
                                            const Wide& a) {
    const Number kLog2E = 1.44269504088896341;
    const Number value = Reference::weighted_log2_1p(w.v, s.v, c.v, a.v);
    const Number by_weight = Reference::weighted_log2_1p(w.d, s.v, c.v, a.v);
    const Number inverse_s = Number(1) / max(s.v, Number(1e-250));
    const Number change = kLog2E * ((s.d + c.d) / a.v - c.d / c.v);
    return {value, by_weight + inverse_s * (w.v * change - value * s.d)};
  }

  static GONIO_INLINE Power exp2(const Wide& x) { return x; }
  static GONIO_INLINE Real times_exp2(const Real& amplitude, const Power& x) {
    const Number kLog2 = 0.693147180559945309;
    const Number value = Reference::times_exp2(amplitude.v, x.v);
    return {value, Reference::times_exp2(amplitude.d, x.v) + kLog2 * value * x.d};
  }
};

}  // namespace gonio::GONIO_ISA
