// Drawing directions from a power of the cosine to the mirror direction, wr, and the density of
// what is drawn: (s+1)/(2 pi) (wr.wo)^s, made larger by what the horizon would have taken.
//
// Around wr the half towards the normal is all above the horizon; the other reaches down to it. As
// in parts/horizon.h, an axis is drawn first, then a place on the way along it.
#pragma once

#include <cmath>

#include "parts/cosine_power.h"
#include "parts/horizon.h"

namespace gonio {

// What the density needs of a pair of directions.
template <class N>
struct MirrorAim {
  using Real = typename N::Real;
  Real low;     // sin(theta_i) cos(azimuth about wr) sin(angle to wr)
  Real z;       // cos(theta_i) sin(angle to wr)
  Real facing;  // 1 within 90 degrees of wr, 0 beyond, where nothing is drawn (but 0^0 = 1)

  GONIO_INLINE MirrorAim() = default;
  explicit GONIO_INLINE MirrorAim(const Geometry<N>& g) {
    using Wide = typename N::Wide;
    using std::sqrt;
    const cosine_power::Mirror<N> mirror(g);
    const Wide away = mirror.one_minus_cos(g.half);
    low = N::real(g.wi.z * away - mirror.difference);
    const Real sin2 = N::real(away * (Wide(2) - away));
    z = g.cos_i() * sqrt(max(sin2, Real(0)) + Real(1e-30));
    facing = select(Wide(0) < mirror.cos, Real(1), Real(0));
  }

  // pdf = (s+1)/(2 pi) (wr.wo)^s gain.
  [[nodiscard]] GONIO_INLINE Real gain(const PowerProfile<N>& profile) const {
    const Real low2 = low * low, z2 = z * z, inverse = Real(1) / max(low2 + z2, Real(1e-37));
    const Colatitude<Real> limit{z2 * inverse, low2 * inverse};
    return facing * Real(2) / (Real(1) + profile.mass(limit).one_minus);
  }
};

template <class N>
GONIO_INLINE Vec3<typename N::Real> draw_about_mirror(const PowerProfile<N>& profile,
                                                      const Vec3<typename N::Real>& wi,
                                                      const typename N::Real& u,
                                                      const typename N::Real& v) {
  using Real = typename N::Real;
  using std::sqrt;
  const auto axis = turn(Real(0.5) * u);
  // About wr = (-x, -y, z): the tangent that rises to the normal, and the one in the surface.
  const Real sin2 = sum_of_products(wi.x, wi.x, wi.y, wi.y), sine_i = sqrt(sin2);
  const auto tilted = Real(1e-15) < sine_i;
  const Real inverse = Real(1) / select(tilted, sine_i, Real(1));
  const Real x = select(tilted, wi.x * inverse, Real(1));
  const Real y = select(tilted, wi.y * inverse, Real(0));
  // The rising side is all above the horizon.
  const Real low = axis.cos * sine_i, low2 = low * low, z2 = wi.z * wi.z;
  const Real scale = Real(1) / (low2 + z2);
  const Real low_mass = profile.mass(Colatitude<Real>{z2 * scale, low2 * scale}).one_minus;
  const auto rises = Real(0) < axis.cos;
  const Along<Real> place =
      along(v, select(rises, Real(1), low_mass), select(rises, low_mass, Real(1)));
  const Colatitude<Real> angle = profile.at(place.mass);
  const Real sine = place.sign * sqrt(angle.sin2), cosine = sqrt(angle.cos2);
  const Real up = sine * axis.cos, across = sine * axis.sin;
  return {sum_of_products(up * wi.z, x, across, y) - cosine * wi.x,
          sum_of_products(up * wi.z, y, -across, x) - cosine * wi.y,
          sum_of_products(up, sine_i, cosine, wi.z)};
}

}  // namespace gonio
