// What every model reads of a pair of directions, in the local frame with normal (0,0,1).
//
// Directions come in up to 1e-3 off unit length and are normalised here. What cancels is formed in
// the wide type: near the mirror direction H.x and H.y are small differences of large numbers, near
// retro-reflection wi - wo is. The half-vector is kept unnormalised, H = wi + wo. What only
// multiplies (the cosines) is formed in the real type.
//
// Where wi is nearly -wo, H is what is left of two vectors that have just been rounded. Where
// errors of 1e-14 count it is therefore formed from the directions a and b as given, whose sum is
// exact: a/|a| + b/|b| = (a + b)/|a| + (1/|b| - 1/|a|) b, the difference of the inverse lengths
// following from |a|^2 - |b|^2 = (a - b).(a + b).
#pragma once

#include <type_traits>

#include "numeric/inline.h"
#include "numeric/vec.h"
#include "parts/rotation.h"

namespace gonio {

// Lengths within this of 1 are corrected; beyond, a direction is refused.
inline constexpr double kLengthTolerance = 1e-3;

// |k|^2 - 1 without losing the small difference.
template <class T>
GONIO_INLINE T length_error(const Vec3<T>& k) {
  return (k.z * k.z - T(1)) + k.x * k.x + k.y * k.y;
}
// Whether e = |k|^2 - 1 lies between (1 - tol)^2 - 1 and (1 + tol)^2 - 1; false for NaN.
template <class T>
GONIO_INLINE auto near_unit(const T& e) {
  const T from_centre = e - T(kLengthTolerance * kLengthTolerance);
  return from_centre * from_centre < T(4 * kLengthTolerance * kLengthTolerance);
}

// H = wi + wo, and what follows from it alone.
template <class N>
struct HalfVector {
  using Wide = typename N::Wide;
  using Real = typename N::Real;
  struct Nothing {};

  Vec3<Wide> h;  // not normalised
  // |wi - wo|^2, where the last digits of sin(theta_d) count.
  [[no_unique_address]] std::conditional_t<N::kQuick, Nothing, Wide> difference2;

  [[nodiscard]] GONIO_INLINE Wide length2() const { return dot(h, h); }  // 4 cos^2(theta_d)
  [[nodiscard]] GONIO_INLINE Wide cos2_d() const { return length2() * Wide(0.25); }  // (h.k)^2
  // sin^2(theta_d); near wi = wo it may be -1e-16 for quick numbers.
  [[nodiscard]] GONIO_INLINE Wide sin2_d() const {
    if constexpr (N::kQuick) {
      return Wide(1) - length2() * Wide(0.25);
    } else {
      return difference2 * Wide(0.25);
    }
  }
};

template <class N>
class Geometry {
 public:
  using Wide = typename N::Wide;
  using Real = typename N::Real;

  Vec3<Wide> wi, wo;            // unit
  Vec3<Real> real_wi, real_wo;  // the same, each component to the precision of Real
  HalfVector<N> half;
  typename N::Mask valid;  // both finite, within the tolerance and above the horizon

  // The directions as given, in both types.
  GONIO_INLINE Geometry(const Vec3<Wide>& wide_i, const Vec3<Wide>& wide_o,
                        const Vec3<Real>& given_i, const Vec3<Real>& given_o) {
    const Wide inverse_i = N::inverse_length(length_error(wide_i)),
               inverse_o = N::inverse_length(length_error(wide_o));
    wi = inverse_i * wide_i;
    wo = inverse_o * wide_o;
    if constexpr (N::kQuick) {
      half.h = combine(inverse_i, wide_i, inverse_o, wide_o);
    } else {
      const Vec3<Wide> sum = wide_i + wide_o, d = combine(inverse_i, wide_i, -inverse_o, wide_o);
      const Wide excess = dot(wide_i - wide_o, sum);  // |a|^2 - |b|^2
      const Wide product = inverse_i * inverse_o;
      const Wide change = excess * (product * product / (inverse_i + inverse_o));
      half.h = combine(inverse_i, sum, change, wide_o);
      half.difference2 = dot(d, d);
    }
    given_i_ = wide_i;
    given_o_ = wide_o;
    inverse_i_ = inverse_i;
    inverse_o_ = inverse_o;
    const Real error_i = length_error(given_i), error_o = length_error(given_o);
    real_wi = N::inverse_length(error_i) * given_i;
    real_wo = N::inverse_length(error_o) * given_o;
    // min may lose a NaN, but then the length's comparison fails.
    valid = near_unit(error_i) & near_unit(error_o) & (Real(0) < min(given_i.z, given_o.z));
  }

  // Goes on with the directions as seen from tangents that are turned about the normal. Turned in
  // float64 after all that cancels, they and H keep their digits; lengths, cosines with the normal
  // and mirror_cosine() are what they were.
  GONIO_INLINE void turn(const Rotation<typename N::WideScalar>& tangents) {
    wi = into(tangents, wi), wo = into(tangents, wo);
    half.h = into(tangents, half.h);
    real_wi = {N::real(wi.x), N::real(wi.y), real_wi.z};
    real_wo = {N::real(wo.x), N::real(wo.y), real_wo.z};
  }

  GONIO_INLINE Real cos_i() const { return real_wi.z; }
  GONIO_INLINE Real cos_o() const { return real_wo.z; }
  // The cosine between wo and the mirror image of wi, to its last digits where it is nearly 0, too.
  GONIO_INLINE Wide mirror_cosine() const {
    const Vec3<Wide> mirrored{-given_i_.x, -given_i_.y, given_i_.z};
    return inverse_i_ * inverse_o_ * N::exact_dot(mirrored, given_o_);
  }
  // n.wi - n.wo.
  GONIO_INLINE Wide cosine_difference() const {
    return sum_of_products(inverse_i_, given_i_.z, -inverse_o_, given_o_.z);
  }

 private:
  Vec3<Wide> given_i_, given_o_;
  Wide inverse_i_, inverse_o_;  // of the lengths as given
};

}  // namespace gonio
