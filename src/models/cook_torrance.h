// cook_torrance: microfacets in V-grooves, their normals after Beckmann or a cosine power.
//
//   f = scale F D G / (4 (n.wi) (n.wo))
//   D = exp(-tan^2(delta) / m^2) / (pi m^2 cos^4(delta)),   cos(delta) = n.h
//   or (s + 2) / (2 pi) cos^s(delta)
//   G = min(1, 2 (n.h)(n.wo) / (wo.h), 2 (n.h)(n.wi) / (wi.h))
//
// Source: Cook & Torrance 1982, "A Reflectance Model for Computer Graphics" (with pi and 4 as they
// must be for D to be a distribution: the integral of D cos is 1). Stable forms: with H = wi + wo
// unnormalised, G / (4 cos_i cos_o) = Hz / (cos_max max(4 cos_min Hz, |H|^2)), which is finite
// where the cosines vanish; 1/cos^2(delta) = |H|^2 / Hz^2.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "gonio/models/description.h"
#include "parts/cosine_power.h"
#include "parts/half_vector_sampling.h"
#include "parts/lobe.h"

namespace gonio {

struct CookTorrance {
  static constexpr std::array<std::string_view, 2> kDistributions{"beckmann", "cosine_power"};
  static constexpr std::array<std::string_view, 1> kBeckmann{"beckmann"},
      kCosinePower{"cosine_power"};
  static constexpr auto kParameters = with_fresnel(
      Parameter{.name = "distribution",
                .meaning = "of the microfacets' normals; if not given, it follows from m and s",
                .unit = "1",
                .type = ParameterType::word,
                .words = kDistributions},
      Parameter{.name = "m",
                .meaning = "Beckmann's root mean square slope",
                .unit = "1",
                .lower = 1e-3,
                .upper = 2,
                .start = 0.3,
                .scale = Scale::logarithmic,
                .used_with = {"distribution", kBeckmann}},
      cosine_power::exponent_used_with({"distribution", kCosinePower}));
  static constexpr ModelDescription kDescription{
      .name = "cook_torrance",
      .summary = "V-groove microfacets with Beckmann's distribution, or a cosine power",
      .source = "Cook & Torrance 1982, A Reflectance Model for Computer Graphics",
      .role = Role::specular,
      .parameters = kParameters,
      .fast = {.relative = 3e-6, .note = cosine_power::kFastNote},
      .reference = {.relative = 3e-9,
                    .note = "5e-8 for exponents above 5e4 where both cosines are below 1e-4; "
                            "3e-11 for m of 0.03 and more, s up to 1000"}};

  struct Beckmann;
  struct CosinePower;
  template <class Distribution>
  struct WithDistribution;
  using Kinds = Concatenated<FresnelKinds<WithDistribution<Beckmann>>,
                             FresnelKinds<WithDistribution<CosinePower>>>;
};

// D as a power of two times a factor.
struct CookTorrance::Beckmann {
  template <class S>
  struct Shape {
    S minus_inverse_m2, norm;  // the first times log2(e)
  };
  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    const S m = p.number("m");
    return {S(-1.44269504088896341) / (m * m), S(1) / (S(std::numbers::pi) * m * m)};
  }
  template <class N>
  static GONIO_INLINE typename N::Wide exponent(const Shape<typename N::WideScalar>& k,
                                                const HalfVector<N>& half) {
    using Wide = typename N::Wide;
    const Vec3<Wide>& h = half.h;
    return sum_of_products(h.x, h.x, h.y, h.y) * Wide(k.minus_inverse_m2) / (h.z * h.z);
  }
  // sec2 = 1/cos^2(delta)
  template <class Real, class S>
  static GONIO_INLINE Real factor(const Shape<S>& k, const Real& sec2) {
    return Real(k.norm) * (sec2 * sec2);
  }
  // Of D cos(delta).
  template <class N>
  static GONIO_INLINE SlopeProfile<N> profile(const Shape<typename N::WideScalar>& k) {
    return {typename N::Real(k.minus_inverse_m2)};
  }
};

struct CookTorrance::CosinePower {
  template <class S>
  struct Shape {
    S minus_half_s, norm;
  };
  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    const S s = p.number("s");
    return {S(-0.5) * s, (s + S(2)) / S(2 * std::numbers::pi)};
  }
  template <class N>
  static GONIO_INLINE typename N::Wide exponent(const Shape<typename N::WideScalar>& k,
                                                const HalfVector<N>& half) {
    return cosine_power::of_half_vector<N>(k.minus_half_s, half);
  }
  template <class Real, class S>
  static GONIO_INLINE Real factor(const Shape<S>& k, const Real&) {
    return Real(k.norm);
  }
  template <class N>
  static GONIO_INLINE PowerProfile<N> profile(const Shape<typename N::WideScalar>& k) {
    return PowerProfile<N>(1 - k.minus_half_s);
  }
};

template <class Distribution>
struct CookTorrance::WithDistribution {
  template <class S>
  using Shape = typename Distribution::template Shape<S>;

  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    return Distribution::shape(p);
  }

  template <class N>
  struct Stage {
    typename N::Real cos_max, cos_min;  // of n.wi and n.wo
  };

  template <class N>
  static GONIO_INLINE Stage<N> stage(const Shape<typename N::WideScalar>&, const Geometry<N>& g) {
    return {max(g.cos_i(), g.cos_o()), min(g.cos_i(), g.cos_o())};
  }

  template <class N>
  struct Refined {
    typename N::Power power;  // D without its factor
    typename N::Real h2, z;   // |H|^2, Hz
  };

  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>& k,
                                        const HalfVector<N>& half, const Stage<N>&) {
    return {N::exp2(Distribution::template exponent<N>(k, half)), N::real(half.length2()),
            N::real(half.h.z)};
  }

  template <class N>
  static GONIO_INLINE typename N::Real amplitude(const Shape<typename N::WideScalar>& k,
                                                 const Stage<N>& g, const Refined<N>& r) {
    using Real = typename N::Real;
    // Within the stated horizon Beckmann's exponential is 0 wherever a bound acts; beyond, they
    // keep the other factors finite.
    const Real z = max(r.z, Real(1e-12));
    const Real sec2 = min(r.h2 / (z * z), Real(1e9));
    const Real masking = z / max(g.cos_max * max(Real(4) * g.cos_min * z, r.h2), Real(1e-37));
    return N::times_exp2(min(Real(1e37), Distribution::factor(k, sec2) * masking), r.power);
  }

  // Sampling by the visible normals of V-cavities: Heitz & d'Eon 2014, "Importance Sampling
  // Microfacet-Based BSDFs using the Distribution of Visible Normals". A normal and its mirror
  // image are chosen between by their cosines to wi; here only where both reflect to above the
  // horizon, and no normal is drawn that does not.
  template <class N>
  struct Aim {
    HalfVectorAim<N> half;
    typename N::Real cos_i;
  };

  template <class N>
  static GONIO_INLINE Aim<N> aim(const Shape<typename N::WideScalar>&, const Geometry<N>& g) {
    return {HalfVectorAim<N>(g), g.cos_i()};
  }

  template <class N>
  static GONIO_INLINE typename N::Real pdf(const Shape<typename N::WideScalar>& k,
                                           const HalfVector<N>&, const Stage<N>&,
                                           const Refined<N>& r, const Aim<N>& aim) {
    using Real = typename N::Real;
    const Colatitude<Real> lit = reach(aim.half.toward, aim.half.z2);
    const Real mass = Distribution::template profile<N>(k).mass_beyond_45(lit);
    const Real z = max(r.z, Real(1e-12)), sec2 = min(r.h2 / (z * z), Real(1e9));
    // D cos(delta) / (4 wi.h), times 2, times wi.h / (2 (n.wi) cos(delta)) where the mirror image
    // could be chosen as well.
    const auto alone = (Real(0) < aim.half.toward) & (lit.cos2 * r.h2 < aim.half.x2 + aim.half.y2);
    const Real above = select(alone, z, Real(0.25)), below = select(alone, r.h2, aim.cos_i) * mass;
    return N::times_exp2(min(Real(1e37), Distribution::factor(k, sec2) * above / below), r.power);
  }

  template <class N>
  static GONIO_INLINE Vec3<typename N::Real> sample(const Shape<typename N::WideScalar>& k,
                                                    const Vec3<typename N::Real>& wi,
                                                    const Xi<typename N::Real>& xi) {
    using Real = typename N::Real;
    using std::sqrt;
    const auto phi = half_turn(xi.u);
    const Tangent<Real> axis{phi.cos, phi.sin};
    const Real toward = sum_of_products(wi.x, axis.x, wi.y, axis.y);
    const Colatitude<Real> lit = reach(toward, wi.z * wi.z);
    const auto profile = Distribution::template profile<N>(k);
    const Colatitude<Real> theta = profile.at(xi.v * profile.mass_beyond_45(lit));
    // The share of the side of the light: its cosine to wi over that of both.
    const Real up = wi.z * theta.cos2;
    const Real facing = up + absolute(toward) * sqrt(theta.sin2 * theta.cos2);
    const Real share = select(theta.sin2 < lit.cos2, facing, up + up);
    const auto to_light = xi.choice * (up + up) < share;
    const Real side = select(Real(0) < toward, Real(1), Real(-1));
    return reflected(wi, axis, toward, theta, select(to_light, side, -side));
  }
};

}  // namespace gonio
