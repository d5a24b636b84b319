// Drawing directions by their half-vector, for lobes that are a profile of its colatitude at each
// azimuth, and the density of what is drawn: that of h over 4 h.wi (Ashikhmin & Shirley 2000, eq.
// 8), made larger by what the horizon would have taken (parts/horizon.h).
#pragma once

#include <cmath>

#include "parts/geometry.h"
#include "parts/horizon.h"

namespace gonio {

// A unit vector in the surface.
template <class T>
struct Tangent {
  T x, y;
};

template <class T>
GONIO_INLINE Tangent<T> unit_tangent(const T& x, const T& y) {
  using std::sqrt;
  const T inverse = T(1) / sqrt(sum_of_products(x, x, y, y));
  return {x * inverse, y * inverse};
}

// wo for an axis of azimuths of h with its profile.
template <class N, class Profile>
GONIO_INLINE Vec3<typename N::Real> draw_by_half_vector(const Profile& profile,
                                                        const Tangent<typename N::Real>& axis,
                                                        const Vec3<typename N::Real>& wi,
                                                        const typename N::Real& v) {
  using Real = typename N::Real;
  using std::sqrt;
  const Real toward = sum_of_products(wi.x, axis.x, wi.y, axis.y);
  const Colatitude<Real> lit = reach(toward, wi.z);
  const Real lit_mass = profile.mass(lit).one_minus;
  const Real other_mass = profile.mass(Colatitude<Real>{lit.cos2, lit.sin2}).one_minus;
  const auto faces = Real(0) < toward;
  const Along<Real> place =
      along(v, select(faces, lit_mass, other_mass), select(faces, other_mass, lit_mass));
  const Colatitude<Real> theta = profile.at(place.mass);
  const Real sine = place.sign * sqrt(theta.sin2);
  return reflected(wi, {sine * axis.x, sine * axis.y, sqrt(theta.cos2)});
}

// What the density needs of a pair of directions: h's tangential part and where it points, up to
// the factor |wi + wo|.
template <class N>
struct HalfVectorAim {
  using Real = typename N::Real;
  Real x2, y2, toward, z, cos_i;

  GONIO_INLINE HalfVectorAim() = default;
  explicit GONIO_INLINE HalfVectorAim(const Geometry<N>& g) {
    using std::sqrt;
    const auto& h = g.half.h;
    x2 = N::real(h.x * h.x), y2 = N::real(h.y * h.y);
    toward = N::real(sum_of_products(h.x, g.wi.x, h.y, g.wi.y));
    // The addend gives an azimuth, across wi, to what has none.
    cos_i = g.cos_i();
    z = cos_i * sqrt(x2 + y2 + Real(1e-30));
  }
  // a cos^2(phi) + b sin^2(phi)
  [[nodiscard]] GONIO_INLINE Real by_azimuth(const Real& a, const Real& b) const {
    return sum_of_products(a, x2, b, y2) / max(x2 + y2, Real(1e-30));
  }
  // 2 over the masses of both sides above the horizon.
  template <class Profile>
  [[nodiscard]] GONIO_INLINE Real gain(const Profile& profile) const {
    const Colatitude<Real> lit = reach(toward, z);
    return Real(2) / (profile.mass(lit).one_minus +
                      profile.mass(Colatitude<Real>{lit.cos2, lit.sin2}).one_minus);
  }
};

}  // namespace gonio
