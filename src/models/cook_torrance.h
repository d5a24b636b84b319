// cook_torrance: microfacets in V-grooves with Beckmann's distribution of normals.
//
//   f = scale F D G / (4 (n.wi) (n.wo))
//   D = exp(-tan^2(delta) / m^2) / (pi m^2 cos^4(delta)),   cos(delta) = n.h
//   G = min(1, 2 (n.h)(n.wo) / (wo.h), 2 (n.h)(n.wi) / (wi.h))
//
// Source: Cook & Torrance 1982, "A Reflectance Model for Computer Graphics" (with pi and 4 as they
// must be for D to be a distribution: the integral of D cos is 1). Stable forms: with H = wi + wo
// unnormalised, G / (4 cos_i cos_o) = Hz / (cos_max max(4 cos_min Hz, |H|^2)), which is finite
// where the cosines vanish; 1/cos^2(delta) = |H|^2 / Hz^2.
#pragma once

#include <array>

#include "models/description.h"
#include "parts/lobe.h"

namespace gonio {

struct CookTorrance {
  static constexpr std::array kParameters{Parameter{.name = "m",
                                                    .meaning = "Beckmann's root mean square slope",
                                                    .unit = "1",
                                                    .lower = 1e-3,
                                                    .upper = 2,
                                                    .start = 0.3,
                                                    .scale = Scale::logarithmic},
                                          fresnel::kKind,
                                          fresnel::kF0,
                                          fresnel::kEta,
                                          fresnel::kK,
                                          kScale};
  static constexpr ModelDescription kDescription{
      .name = "cook_torrance",
      .summary = "V-groove microfacets with Beckmann's distribution",
      .source = "Cook & Torrance 1982, A Reflectance Model for Computer Graphics",
      .role = Role::specular,
      .parameters = kParameters,
      .fast = {.relative = 3e-6},
      .reference = {.relative = 3e-9, .note = "3e-11 for m of 0.03 and more"}};
  using Kinds = FresnelKinds<CookTorrance>;

  template <class S>
  struct Shape {
    S minus_inverse_m2, norm;  // the first times log2(e)
  };

  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    const S m = p.number("m");
    return {S(-1.44269504088896341) / (m * m), S(1) / (S(3.14159265358979323846) * m * m)};
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
    typename N::Wide exponent;  // -tan^2(theta_h) / m^2 log2(e)
    typename N::Real h2, z;     // |H|^2, Hz
  };

  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>& k,
                                        const HalfVector<N>& half, const Stage<N>&) {
    using Wide = typename N::Wide;
    const Vec3<Wide>& h = half.h;
    const Wide s = sum_of_products(h.x, h.x, h.y, h.y), c = h.z * h.z;
    return {s * Wide(k.minus_inverse_m2) / c, N::real(s + c), N::real(h.z)};
  }

  template <class N>
  static GONIO_INLINE typename N::Real amplitude(const Shape<typename N::WideScalar>& k,
                                                 const Stage<N>& g, const Refined<N>& r) {
    using Real = typename N::Real;
    // Within the stated horizon the exponential is 0 wherever a bound acts; beyond, they keep the
    // other factors finite.
    const Real z = max(r.z, Real(1e-12));
    const Real sec2 = min(r.h2 / (z * z), Real(1e9));
    const Real masking = z / max(g.cos_max * max(Real(4) * g.cos_min * z, r.h2), Real(1e-37));
    return N::times_exp2(min(Real(1e37), Real(k.norm) * (sec2 * sec2) * masking), r.exponent);
  }
};

}  // namespace gonio
