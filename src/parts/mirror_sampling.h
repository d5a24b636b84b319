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
  Real low;           // sin(theta_i) cos(azimuth about wr) sin(angle to wr)
  Real z2;            // the square of cos(theta_i) sin(angle to wr)
  Real cosine, away;  // of the angle to wr, and 1 less that, to its last digits

  GONIO_INLINE MirrorAim() = default;
  explicit GONIO_INLINE MirrorAim(const Geometry<N>& g) {
    const cosine_power::Mirror<N> mirror(g);
    away = N::real(mirror.one_minus_cos(g.half));
    cosine = N::real(mirror.cos);
    low = g.cos_i() * away - N::real(mirror.difference);
    z2 = g.cos_i() * g.cos_i() * (max(away * (Real(2) - away), Real(0)) + Real(1e-30));
  }

  // pdf = (s+1)/(2 pi) (wr.wo)^s gain; 0 beyond 90 degrees, where nothing is drawn (but 0^0 = 1).
  [[nodiscard]] GONIO_INLINE Real gain(const PowerProfile<N>& profile) const {
    const Real low2 = low * low, inverse = Real(1) / max(low2 + z2, Real(1e-37));
    const Colatitude<Real> limit{z2 * inverse, low2 * inverse};
    return select(Real(0) < cosine, Real(2), Real(0)) / (Real(1) + profile.mass(limit));
  }
};

// An axis about wr = (-x, -y, z): its parts along the tangent at wr that rises to the normal, x,
// and along the one in the surface, y.
template <class T>
struct MirrorAxis {
  Tangent<T> at;
  T sine_i, x, y;  // sin(theta_i), and wi's azimuth

  GONIO_INLINE MirrorAxis(const Tangent<T>& axis, const Vec3<T>& wi) : at(axis) {
    using std::sqrt;
    sine_i = sqrt(sum_of_products(wi.x, wi.x, wi.y, wi.y));
    const auto tilted = T(1e-15) < sine_i;
    const T inverse = T(1) / select(tilted, sine_i, T(1));
    x = select(tilted, wi.x * inverse, T(1));
    y = select(tilted, wi.y * inverse, T(0));
  }
  // How far the falling side reaches; the rising side is all above the horizon.
  [[nodiscard]] GONIO_INLINE Colatitude<T> limit(const Vec3<T>& wi) const {
    const T low = at.x * sine_i, low2 = low * low, z2 = wi.z * wi.z, scale = T(1) / (low2 + z2);
    return {z2 * scale, low2 * scale};
  }
  // The direction at this angle from wr, on one side of the axis or, for -1, the other.
  [[nodiscard]] GONIO_INLINE Vec3<T> direction(const Vec3<T>& wi, const Colatitude<T>& angle,
                                               const T& side) const {
    using std::sqrt;
    const T sine = side * sqrt(angle.sin2), cosine = sqrt(angle.cos2);
    const T up = sine * at.x, across = sine * at.y;
    return {sum_of_products(up * wi.z, x, across, y) - cosine * wi.x,
            sum_of_products(up * wi.z, y, -across, x) - cosine * wi.y,
            sum_of_products(up, sine_i, cosine, wi.z)};
  }
};

template <class N>
GONIO_INLINE Vec3<typename N::Real> draw_about_mirror(const PowerProfile<N>& profile,
                                                      const Vec3<typename N::Real>& wi,
                                                      const typename N::Real& u,
                                                      const typename N::Real& v) {
  using Real = typename N::Real;
  const auto phi = half_turn(u);
  const MirrorAxis<Real> axis({phi.cos, phi.sin}, wi);
  const Real low_mass = profile.mass(axis.limit(wi));
  const auto rises = Real(0) < axis.at.x;
  const Along<Real> place =
      along(v, select(rises, Real(1), low_mass), select(rises, low_mass, Real(1)));
  return axis.direction(wi, profile.at(place.mass), place.sign);
}

}  // namespace gonio
