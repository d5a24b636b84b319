// Drawing directions by their half-vector, for lobes that are a profile of its colatitude at each
// azimuth, and the density of what is drawn: that of h over 4 h.wi (Ashikhmin & Shirley 2000, eq.
// 8), made larger by what the horizon would have taken (parts/horizon.h).
#pragma once

#include <cmath>

#include "parts/geometry.h"
#include "parts/horizon.h"

namespace gonio {

// wo for an axis of azimuths of h with its profile.
template <class N, class Profile>
GONIO_INLINE Vec3<typename N::Real> draw_by_half_vector(const Profile& profile,
                                                        const Tangent<typename N::Real>& axis,
                                                        const Vec3<typename N::Real>& wi,
                                                        const typename N::Real& v) {
  using Real = typename N::Real;
  const Real toward = sum_of_products(wi.x, axis.x, wi.y, axis.y);
  const Colatitude<Real> lit = reach(toward, wi.z * wi.z);
  const Real lit_mass = profile.mass_beyond_45(lit);
  const Real other_mass = profile.mass(Colatitude<Real>{lit.cos2, lit.sin2});
  const auto faces = Real(0) < toward;
  const Along<Real> place =
      along(v, select(faces, lit_mass, other_mass), select(faces, other_mass, lit_mass));
  return reflected(wi, axis, toward, profile.at(place.mass), place.sign);
}

// What the density needs of a pair of directions: the squares of H = wi + wo's components, and
// where it points, up to the factor |H|.
template <class N>
struct HalfVectorAim {
  using Real = typename N::Real;
  Real x2, y2, hz2, toward, z2;

  GONIO_INLINE HalfVectorAim() = default;
  explicit GONIO_INLINE HalfVectorAim(const Geometry<N>& g) {
    const auto& h = g.half.h;
    x2 = N::real(h.x * h.x), y2 = N::real(h.y * h.y);
    hz2 = N::real(h.z * h.z);
    toward = N::real(sum_of_products(h.x, g.wi.x, h.y, g.wi.y));
    // The addend gives an azimuth, across wi, to what has none.
    z2 = g.cos_i() * g.cos_i() * (x2 + y2 + Real(1e-30));
  }
  [[nodiscard]] GONIO_INLINE Real length2() const { return x2 + y2 + hz2; }
  // a cos^2(phi) + b sin^2(phi)
  [[nodiscard]] GONIO_INLINE Real by_azimuth(const Real& a, const Real& b) const {
    return sum_of_products(a, x2, b, y2) / max(x2 + y2, Real(1e-30));
  }
  // The masses of both sides above the horizon.
  template <class Profile>
  [[nodiscard]] GONIO_INLINE Real masses(const Profile& profile) const {
    const Colatitude<Real> lit = reach(toward, z2);
    return profile.mass_beyond_45(lit) + profile.mass(Colatitude<Real>{lit.cos2, lit.sin2});
  }
  // 2 / (4 h.wi) over the masses: what makes a density of h one of wo.
  template <class Profile>
  [[nodiscard]] GONIO_INLINE Real gain(const Profile& profile) const {
    using std::sqrt;
    return Real(1) / (masses(profile) * max(sqrt(length2()), Real(1e-29)));
  }
};

}  // namespace gonio
