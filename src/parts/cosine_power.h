// Powers of a cosine, what Phong-like lobes are made of: of the mirror direction, cos = wr.wo with
// wr the mirror image of wi, and of the half-vector, n.h.
//
// Powers are kept as base-2 logarithms. Near the lobe's centre, where a large exponent magnifies
// every rounding, the logarithm comes from 1 - cos, formed without cancelling: 1 - wr.wo = |wr -
// wo|^2 / 2, and wr - wo has the components -Hx, -Hy and the difference of the cosines.
#pragma once

#include <string_view>

#include "gonio/models/description.h"
#include "parts/geometry.h"

namespace gonio::cosine_power {

inline constexpr Parameter kExponent{.name = "s",
                                     .meaning = "Phong exponent",
                                     .unit = "1",
                                     .lower = 0,
                                     .upper = 1e7,
                                     .start = 100,
                                     .scale = Scale::logarithmic};

// The same for one of several distributions.
constexpr Parameter exponent_used_with(UsedWith used_with) {
  Parameter exponent = kExponent;
  exponent.used_with = used_with;
  return exponent;
}

// Where errors of powers of n.h are larger: both directions all but in the surface and opposite, H
// is what two unit vectors leave of each other, 1e-8 of them, and its error is as large to it.
inline constexpr std::string_view kFastNote =
    "5e-5 for exponents above 5e4 where both cosines are below 1e-4";
inline constexpr std::string_view kReferenceNote =
    "5e-8 for exponents above 5e4 where both cosines are below 1e-4; "
    "3e-11 for exponents up to 1000";

// log2 of (n.h)^s, from -s/2.
template <class N>
GONIO_INLINE typename N::Wide of_half_vector(const typename N::WideScalar& minus_half_s,
                                             const HalfVector<N>& half) {
  using Wide = typename N::Wide;
  const Vec3<Wide>& h = half.h;
  const Wide sine2 = sum_of_products(h.x, h.x, h.y, h.y);
  return N::weighted_log2_1p(Wide(minus_half_s) * sine2, sine2, h.z * h.z, half.length2());
}

// What the mirror direction's cosine needs of a pair beside its half-vector.
template <class N>
struct Mirror {
  typename N::Wide cos, difference;  // wr.wo; n.wi - n.wo

  explicit GONIO_INLINE Mirror(const Geometry<N>& g)
      : cos(g.mirror_cosine()), difference(g.cosine_difference()) {}
  GONIO_INLINE Mirror() = default;

  [[nodiscard]] GONIO_INLINE typename N::Wide one_minus_cos(const HalfVector<N>& half) const {
    using Wide = typename N::Wide;
    const Wide across = sum_of_products(half.h.x, half.h.x, half.h.y, half.h.y);
    return Wide(0.5) * (across + difference * difference);
  }
};

// What log2 of base^s is where base = 0, a number for 2^x to take: 0^0 = 1, as in the limit.
template <class S>
S log2_of_zero(const S& s) {
  return S(0) < s ? S(-1e4) : S(0);
}

// log2 of base^s, from -s and 1 - base; 0 counts for a base below 0.
template <class N>
GONIO_INLINE typename N::Wide of_base(const typename N::WideScalar& minus_s,
                                      const typename N::WideScalar& of_zero,
                                      const typename N::Wide& base,
                                      const typename N::Wide& one_minus_base) {
  using Wide = typename N::Wide;
  const Wide log2 = N::weighted_log2_1p(Wide(minus_s) * one_minus_base, one_minus_base,
                                        max(base, Wide(1e-140)), Wide(1));
  return select(Wide(0) < base, log2, Wide(of_zero));
}

}  // namespace gonio::cosine_power
