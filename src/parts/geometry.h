// What every model reads of a pair of directions, in the local frame with normal (0,0,1).
//
// Directions come in up to 1e-3 off unit length and are normalised here. The half-vector is kept unnormalised,
// H = wi + wo, and everything that cancels is formed in the wide type: near the mirror direction H.x and H.y are small
// differences of large numbers; near retro-reflection wi - wo is.
#pragma once

#include "numeric/inline.h"
#include "numeric/vec.h"

namespace gonio {

// | |k|^2 - 1 | for directions that are corrected: lengths within 1e-3 of 1.
inline constexpr double kLengthTolerance = 1e-3;

template <class N>
struct Geometry {
  using Wide = typename N::Wide;
  using Real = typename N::Real;

  Vec3<Wide> wi, wo;    // unit
  typename N::Mask valid;  // both within the tolerance, finite and above the horizon

  GONIO_INLINE Geometry(const Vec3<Wide>& given_i, const Vec3<Wide>& given_o) {
    const Wide ei = length_error(given_i);
    const Wide eo = length_error(given_o);
    wi = N::inverse_length(ei) * given_i;
    wo = N::inverse_length(eo) * given_o;
    // Both bounds at once: |k|^2 - 1 lies between (1 - tol)^2 - 1 and (1 + tol)^2 - 1. A NaN fails every comparison; min
    // may lose one, but then its length fails.
    constexpr double kCentre = kLengthTolerance * kLengthTolerance, kRadius = 2 * kLengthTolerance;
    const Wide d_i = ei - Wide(kCentre), d_o = eo - Wide(kCentre);
    const Wide radius2(kRadius * kRadius);
    valid = (d_i * d_i < radius2) & (d_o * d_o < radius2) & (Wide(0) < min(given_i.z, given_o.z));
  }

  // |k|^2 - 1 without losing the small difference.
  static GONIO_INLINE Wide length_error(const Vec3<Wide>& k) { return (k.z * k.z - Wide(1)) + k.x * k.x + k.y * k.y; }

  GONIO_INLINE Real cos_i() const { return N::real(wi.z); }
  GONIO_INLINE Real cos_o() const { return N::real(wo.z); }
  GONIO_INLINE Wide cos_max() const { return max(wi.z, wo.z); }
  GONIO_INLINE Wide cos_min() const { return min(wi.z, wo.z); }

  GONIO_INLINE Vec3<Wide> h() const { return wi + wo; }  // H, not normalised
  GONIO_INLINE Wide h_length2() const {                   // |H|^2 = 4 cos^2(theta_d)
    const Vec3<Wide> v = h();
    return dot(v, v);
  }
  GONIO_INLINE Wide cos2_d() const { return min(h_length2() * Wide(0.25), Wide(1)); }  // (h.k)^2
  // 1 - h.k = |wi - wo|^2 / (4 (1 + h.k)), given h.k.
  GONIO_INLINE Real one_minus(Real cos_d) const {
    const Vec3<Wide> d = wi - wo;
    return N::real(dot(d, d) * Wide(0.25)) / (Real(1) + cos_d);
  }
};

}  // namespace gonio
