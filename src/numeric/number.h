// Number systems: what a model's template is instantiated with.
//
// A number system N offers
//   Wide, Real         types of geometry, and of colours and results: float64 packets; float32
//                      packets for Fast's Real. Both with + - * / < min max select
//   Mask, Out          the result of a comparison; the number that results are stored as
//   WideScalar, RealScalar         types of a material's constants that go with them
//   largest()          the largest finite Out
//   real(w)            Wide to Real
//   root(w)            square root of a Wide, as Real; 0 where Real cannot hold it
//   inverse_length(e)  1 / sqrt(1 + e), of either type
//   exact_dot(a, b)    the product of two vectors as given, where it nearly vanishes, too
//   weighted_log2_1p(w, s, c, a)   (w/s) log2(1 + s/c), a = s + c
//   angle(y, x)        of (x, y), both at least 0
//   exp2(x), times_exp2(a, p)      p = 2^x, x <= 0, as a Power; a p, without underflow before the
//                                  product
//   kQuick             whether errors of 1e-14 are small enough to save work for
//
// Fast and Reference are here, derivatives in derivative.h, scalars of long double in extended.h.
#pragma once

#include "numeric/elementary.h"
#include "numeric/packet.h"

namespace gonio::GONIO_ISA {

// float32 in and out. The wide chain is float64 with quick divisions.
struct Fast {
  using WideScalar = double;
  using RealScalar = float;
  using Wide = Double<Exactness::quick>;
  using Real = Float;
  using Mask = GONIO_ISA::Mask;
  using Out = float;
  using Power = QuickPower;
  static constexpr bool kQuick = true;

  static GONIO_INLINE Real largest() { return Real(3.4028234663852886e38); }
  static GONIO_INLINE Real real(Wide w) { return narrow(w); }
  static GONIO_INLINE Real root(Wide w) { return sqrt(narrow(w)); }
  // For |e| <= 2.1e-3, with relative errors kInverseLengthError and kFloatInverseLengthError.
  static GONIO_INLINE Wide inverse_length(Wide e) {
    static constexpr double kSeries[] = {1, -1.0 / 2, 3.0 / 8, -5.0 / 16, 35.0 / 128, -63.0 / 256};
    return polynomial(e, kSeries);
  }
  static GONIO_INLINE Real inverse_length(Real e) {
    static constexpr double kSeries[] = {1, -1.0 / 2, 3.0 / 8};
    return polynomial(e, kSeries);
  }
  static GONIO_INLINE Wide exact_dot(const Vec3<Wide>& a, const Vec3<Wide>& b) {
    return GONIO_ISA::exact_dot(a, b);
  }
  static GONIO_INLINE Wide angle(Wide y, Wide x) { return first_quadrant_angle(y, x); }
  static GONIO_INLINE Wide weighted_log2_1p(Wide w, Wide s, Wide c, Wide a) {
    return GONIO_ISA::weighted_log2_1p(w, s, c, a);
  }
  static GONIO_INLINE Power exp2(Wide x) { return quick_exp2(x); }
  static GONIO_INLINE Real times_exp2(Real amplitude, Power power) {
    return GONIO_ISA::times_exp2(amplitude, power);
  }
};

// float64 throughout.
struct Reference {
  using WideScalar = double;
  using RealScalar = double;
  using Wide = Double<Exactness::exact>;
  using Real = Wide;
  using Mask = GONIO_ISA::Mask;
  using Out = double;
  using Power = Wide;  // x
  static constexpr bool kQuick = false;

  static GONIO_INLINE Real largest() { return Real(1.7976931348623157e308); }
  static GONIO_INLINE Real real(Wide w) { return w; }
  static GONIO_INLINE Real root(Wide w) { return sqrt(w); }
  static GONIO_INLINE Wide inverse_length(Wide e) { return Wide(1) / sqrt(Wide(1) + e); }
  static GONIO_INLINE Wide exact_dot(const Vec3<Wide>& a, const Vec3<Wide>& b) {
    return GONIO_ISA::exact_dot(a, b);
  }
  static GONIO_INLINE Wide angle(Wide y, Wide x) { return first_quadrant_angle(y, x); }
  static GONIO_INLINE Wide weighted_log2_1p(Wide w, Wide s, Wide c, Wide a) {
    return GONIO_ISA::weighted_log2_1p(w, s, c, a);
  }
  static GONIO_INLINE Power exp2(Wide x) { return x; }
  static GONIO_INLINE Real times_exp2(Real amplitude, Power power) {
    return GONIO_ISA::times_exp2(amplitude, power);
  }
};

}  // namespace gonio::GONIO_ISA
