// Number systems: what a model's template is instantiated with.
//
// A number system N offers
//   N::Wide   geometry up to the exponent: float64 packets, or the scalar itself
//   N::Real   colours and results: float32 packets for Fast, else the same as Wide
//   N::Mask   the result of a comparison
//   real(w) (Wide to Real), sqrt(w) (to Real, also for w beyond float32's range), inverse_length(e), times_exp(a, w)
// and for both number types + - * / < min max select. Constants of a material come as N::Scalar.
#pragma once

#include <cmath>
#include <limits>

#include "numeric/elementary.h"
#include "numeric/packet.h"

namespace gonio {

// Scalars: double, long double or dual numbers. The product's own truth, and the fitter's derivatives.
template <class T>
struct Plain {
  using Scalar = T;
  using Wide = T;
  using Real = T;
  using Mask = bool;
  static T largest() { return T(std::numeric_limits<double>::max()); }
  static T real(T w) { return w; }
  static T root(T w) { using std::sqrt; return sqrt(w); }
  static T inverse_length(T e) { using std::sqrt; return T(1) / sqrt(T(1) + e); }
  static T times_exp(T amplitude, T x) { using std::exp; return amplitude * exp(x); }
  static T log1p_over(T s, T c) { using std::log1p; return s > T(0) ? log1p(s / c) / s : T(1) / c; }
};

}  // namespace gonio

namespace gonio::GONIO_ISA {

// float32 in and out. The wide chain is float64 with quick divisions.
struct Fast {
  using Scalar = double;
  using Wide = Double<Exactness::quick>;
  using Real = Float;
  using Mask = GONIO_ISA::Mask;
  using Out = float;

  static GONIO_INLINE Real largest() { return Real(3.4028234663852886e38); }
  static GONIO_INLINE Real real(Wide w) { return narrow(w); }
  static GONIO_INLINE Real root(Wide w) {
    Real result = sqrt(narrow(w));
    const Mask tiny = w < Wide(1e-30);
    if (any(tiny)) result = select(tiny, sqrt(narrow(w * 0x1p120)) * 0x1p-60, result);
    return result;
  }
  // 1 / sqrt(1 + e) for |e| <= 2.1e-3, to 1e-14.
  static GONIO_INLINE Wide inverse_length(Wide e) {
    static constexpr double kSeries[] = {1, -1.0 / 2, 3.0 / 8, -5.0 / 16, 35.0 / 128};
    return polynomial(e, kSeries);
  }
  static GONIO_INLINE Real times_exp(Real amplitude, Wide x) { return GONIO_ISA::times_exp(amplitude, x); }
  static GONIO_INLINE Wide log1p_over(Wide s, Wide c) { return GONIO_ISA::log1p_over(s, c); }
};

// float64 throughout.
struct Reference {
  using Scalar = double;
  using Wide = Double<Exactness::exact>;
  using Real = Wide;
  using Mask = GONIO_ISA::Mask;
  using Out = double;

  static GONIO_INLINE Real largest() { return Real(1.7976931348623157e308); }
  static GONIO_INLINE Real real(Wide w) { return w; }
  static GONIO_INLINE Real root(Wide w) { return sqrt(w); }
  static GONIO_INLINE Wide inverse_length(Wide e) { return Wide(1) / sqrt(Wide(1) + e); }
  static GONIO_INLINE Real times_exp(Real amplitude, Wide x) { return GONIO_ISA::times_exp(amplitude, x); }
  static GONIO_INLINE Wide log1p_over(Wide s, Wide c) { return GONIO_ISA::log1p_over(s, c); }
};

}  // namespace gonio::GONIO_ISA
