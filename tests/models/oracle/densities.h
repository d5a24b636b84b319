// The densities of the sampling strategies as their papers have them, for the tests.
//
// Written from the formulas alone and sharing nothing with src/, in long double. Each is per solid
// angle of wo, with h the unit half-vector and hk = h.wi = h.wo:
//
//   half-vectors   p(h) / (4 h.wi), p(h) the lobe's own density of h: Ashikhmin & Shirley 2000, eq.
//                  6 and 8, Walter et al. 2007, eq. 28 (with Ward's Gaussian in Beckmann's place)
//   mirror         (s+1)/(2 pi) (wr.wo)^s: Phong's lobe about wr, the mirror image of wi
//   V-cavities     D max(0, h.wi) / (n.wi) / (4 h.wi): Heitz & d'Eon 2014
//   bounded GGX    D / (2 (k n.wi + L(wi))): Eto & Tokuyoshi 2023, listing 2
//
// Of the first three, what reflects below the horizon is left out, azimuth by azimuth: on the line
// of h's azimuth and its opposite, or of wo's about wr, the density is divided by the mass that is
// left of both sides together.
#pragma once

#include "models/oracle/formulas.h"

namespace gonio::testing::densities {

using Real = long double;
using Vector = Vec<Real>;

// The mass within a colatitude, of profiles that have all their mass within 90 degrees: 1 -
// cos(theta)^power, and 1 - exp(-rate tan(theta)^2).
struct Power {
  Real power;
  [[nodiscard]] Real within(Real theta) const {
    const Real sine = std::sin(theta);
    return -std::expm1(power / 2 * std::log1p(-sine * sine));
  }
};
struct Slope {
  Real rate;
  [[nodiscard]] Real within(Real theta) const {
    const Real tangent = std::tan(theta);
    return -std::expm1(-rate * tangent * tangent);
  }
};

// Cosine and sine of an azimuth; across wi where there is none.
struct Azimuth {
  Real cos, sin;
};
inline Azimuth azimuth_of(const Vector& h, const Vector& wi) {
  const Real sine = std::hypot(h.x, h.y);
  if (sine > 0) return {h.x / sine, h.y / sine};
  const Real across = std::hypot(wi.x, wi.y);
  return across > 0 ? Azimuth{-wi.y / across, wi.x / across} : Azimuth{1, 0};
}

// The colatitude at which half-vectors of this azimuth begin to reflect wi to below the horizon:
// the plane of the azimuth sees wi at beta from the normal, and wo is as far on h's other side.
inline Real reach(const Vector& wi, const Azimuth& at) {
  return pi<Real>() / 4 + std::atan2(wi.x * at.cos + wi.y * at.sin, wi.z) / 2;
}

// 2 over the masses of both sides above the horizon.
template <class Profile>
Real gain(const Vector& wi, const Azimuth& at, const Profile& profile) {
  return 2 / (profile.within(reach(wi, at)) + profile.within(reach(wi, {-at.cos, -at.sin})));
}

// sqrt((nu+1)(nv+1)) / (2 pi) (n.h)^e / (4 h.k)
inline Real ashikhmin_shirley(const Vector& wi, const Vector& h, Real hk, Real nu, Real nv) {
  const Azimuth at = azimuth_of(h, wi);
  const Power profile{nu * at.cos * at.cos + nv * at.sin * at.sin + 1};
  return anisotropic_phong(h, nu, nv) * gain(wi, at, profile) / hk;
}

// (s+1)/(2 pi) (n.h)^s / (4 h.k)
inline Real blinn_phong(const Vector& wi, const Vector& h, Real hk, Real s) {
  const Real of_h = (s + 1) / (2 * pi<Real>()) * power(h.z, s);
  return of_h * gain(wi, azimuth_of(h, wi), Power{s + 1}) / (4 * hk);
}

// exp(-tan^2 (cos^2/ax^2 + sin^2/ay^2)) / (pi ax ay (n.h)^3) / (4 h.k)
inline Real ward(const Vector& wi, const Vector& h, Real hk, Real ax, Real ay) {
  const Azimuth at = azimuth_of(h, wi);
  const Real a = h.x / (h.z * ax), b = h.y / (h.z * ay), x = at.cos / ax, y = at.sin / ay;
  const Real of_h = exponential(-(a * a + b * b)) / (pi<Real>() * ax * ay * h.z * h.z * h.z);
  return of_h * gain(wi, at, Slope{x * x + y * y}) / (4 * hk);
}

// About wr, an azimuth and its opposite: one rises from wr to the normal and never meets the
// horizon, the other does where its great circle does.
inline Real phong(const Vector& wi, const Vector& wo, Real s) {
  const Vector wr{-wi.x, -wi.y, wi.z};
  const Real cosine = dot(wr, wo);
  if (!(cosine > 0)) return 0;
  // The tangent at wr towards wo, up to its length: how fast it rises.
  const Vector tangent{wo.x - cosine * wr.x, wo.y - cosine * wr.y, wo.z - cosine * wr.z};
  const Real length = root(dot(tangent, tangent));
  const Real fall = length > 0 ? std::abs(tangent.z) / length : 0;
  const Real limit = std::atan2(wr.z, fall);
  const Real mass = 1 + Power{s + 1}.within(limit);
  return (s + 1) / (2 * pi<Real>()) * power(cosine, s) * 2 / mass;
}

// D cos(delta) is the density of an azimuth's normals, cut where its lit side's reach ends; of the
// normal and its mirror image about n, both of which the V-cavity shows, one is taken by its
// cosine to wi, but the one alone where the other would reflect below the horizon.
template <class Profile>
Real v_cavities(const Vector& wi, const Vector& h, Real hk, Real d, const Profile& profile) {
  const Azimuth at = azimuth_of(h, wi), opposite{-at.cos, -at.sin};
  const bool lit = wi.x * at.cos + wi.y * at.sin > 0;
  const Real longer = reach(wi, lit ? at : opposite), shorter = reach(wi, lit ? opposite : at);
  const Real theta = std::atan2(std::hypot(h.x, h.y), h.z);
  const Real mirrored = h.z * wi.z * 2 - hk;  // wi's cosine to the mirror image
  const Real share = theta > shorter ? Real(lit ? 1 : 0) : hk / (hk + mirrored);
  return 2 * d * h.z / profile.within(longer) * share / (4 * hk);
}

inline Real bounded_ggx(const Vector& wi, const Vector& h, Real ax, Real ay) {
  const Real a = std::min(ax, ay), s = 1 + std::hypot(wi.x, wi.y);
  const Real k = (1 - a * a) * s * s / (s * s + a * a * wi.z * wi.z);
  const Real t = root(ax * wi.x * ax * wi.x + ay * wi.y * ay * wi.y + wi.z * wi.z);
  return trowbridge_reitz(h, ax, ay) / (2 * (k * wi.z + t));
}

}  // namespace gonio::testing::densities
