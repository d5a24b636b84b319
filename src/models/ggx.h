// ggx: microfacets with the anisotropic Trowbridge-Reitz distribution and height-correlated Smith
// masking.
//
//   f = scale F D G2 / (4 (n.wi) (n.wo))
//   D = 1 / (pi ax ay (hx^2/ax^2 + hy^2/ay^2 + hz^2)^2)
//   G2 / (4 (n.wi)(n.wo)) = 1 / (2 ((n.wo) L(wi) + (n.wi) L(wo))),   L(w) = sqrt(ax^2 wx^2 + ay^2
//   wy^2 + wz^2)
//
// Sources: Trowbridge & Reitz 1975; Walter et al. 2007, "Microfacet Models for Refraction"; Heitz
// 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", eq. 85 and 99.
// Stable form: D (n.h)-free as (|H|^2 / (Hx^2/ax^2 + Hy^2/ay^2 + Hz^2))^2 of the unnormalised
// half-vector.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "gonio/models/description.h"
#include "parts/horizon.h"
#include "parts/lobe.h"
#include "parts/roughness.h"

namespace gonio {

struct Ggx {
  static constexpr auto kParameters = with_fresnel(roughness::kAlphaX, roughness::kAlphaY);
  static constexpr ModelDescription kDescription{
      .name = "ggx",
      .summary = "anisotropic Trowbridge-Reitz microfacets with height-correlated Smith masking",
      .source = "Walter et al. 2007, Microfacet Models for Refraction; Heitz 2014, eq. 85, 99",
      .role = Role::specular,
      .parameters = kParameters,
      .fast = {.relative = 3e-6},
      .reference = {.relative = 3e-9, .note = "3e-11 for roughness of 0.03 and more"},
      .along_tangents = roughness::kAlongTangents};
  using Kinds = FresnelKinds<Ggx>;

  template <class S>
  struct Shape {
    S ax2, ay2, inverse_ax2, inverse_ay2, norm;
  };

  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    const S ax = p.number("alpha_x"), ay = p.number("alpha_y");
    return {ax * ax, ay * ay, S(1) / (ax * ax), S(1) / (ay * ay),
            S(0.5) / (S(std::numbers::pi) * ax * ay)};
  }

  template <class N>
  struct Stage {
    typename N::Real visible;  // (n.wo) L(wi) + (n.wi) L(wo)
  };

  template <class N>
  static GONIO_INLINE Stage<N> stage(const Shape<typename N::WideScalar>& k, const Geometry<N>& g) {
    return {
        sum_of_products(g.cos_o(), length<N>(k, g.real_wi), g.cos_i(), length<N>(k, g.real_wo))};
  }

  template <class N>
  struct Refined {
    typename N::Real ratio;  // |H|^2 over the same with the roughness divided out
  };

  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>& k,
                                        const HalfVector<N>& half, const Stage<N>&) {
    using Wide = typename N::Wide;
    const Wide x2 = half.h.x * half.h.x, y2 = half.h.y * half.h.y, z2 = half.h.z * half.h.z;
    // The addend keeps 0/0 away where wi = -wo and both all but touch the surface.
    const Wide stretched =
        sum_of_products(x2, Wide(k.inverse_ax2), y2, Wide(k.inverse_ay2)) + (z2 + Wide(1e-300));
    return {N::real((x2 + y2 + z2) / stretched)};
  }

  template <class N>
  static GONIO_INLINE typename N::Real amplitude(const Shape<typename N::WideScalar>& k,
                                                 const Stage<N>& g, const Refined<N>& r) {
    using Real = typename N::Real;
    return Real(k.norm) * (r.ratio * r.ratio) / max(g.visible, Real(1e-38));
  }

  // Sampling by bounded visible normals: Eto & Tokuyoshi 2023, "Bounded VNDF Sampling for
  // Smith-GGX Reflections", listing 1 and 2. Roughness up to 1.
  template <class N>
  struct Aim {
    typename N::Real above, below;  // 2 pdf / D
  };

  // How far above its lower end the cap of normals is cut, as a fraction: above / below.
  template <class T>
  struct Cap {
    T above, below;
  };
  template <class N>
  static GONIO_INLINE Cap<typename N::Real> cap(const Shape<typename N::WideScalar>& k,
                                                const Vec3<typename N::Real>& wi) {
    using Real = typename N::Real;
    using std::sqrt;
    const double a2 = k.ax2 < k.ay2 ? k.ax2 : k.ay2;
    const Real s = Real(1) + sqrt(sum_of_products(wi.x, wi.x, wi.y, wi.y)), s2 = s * s;
    return {Real(1 - a2) * s2, s2 + Real(a2) * (wi.z * wi.z)};
  }

  template <class N>
  static GONIO_INLINE Aim<N> aim(const Shape<typename N::WideScalar>& k, const Geometry<N>& g) {
    const auto [above, below] = cap<N>(k, g.real_wi);
    return {below, sum_of_products(above, g.cos_i(), below, length<N>(k, g.real_wi))};
  }

  template <class N>
  static GONIO_INLINE typename N::Real pdf(const Shape<typename N::WideScalar>& k,
                                           const HalfVector<N>&, const Stage<N>&,
                                           const Refined<N>& r, const Aim<N>& aim) {
    return typename N::Real(k.norm) * (r.ratio * r.ratio) * aim.above / aim.below;
  }

  // The papers' unit vectors times L(wi), which spares roots and divisions.
  template <class N>
  static GONIO_INLINE Vec3<typename N::Real> sample(const Shape<typename N::WideScalar>& k,
                                                    const Vec3<typename N::Real>& wi,
                                                    const Xi<typename N::Real>& xi) {
    using Real = typename N::Real;
    using std::sqrt;
    const Real l = length<N>(k, wi);
    const auto [above, below] = cap<N>(k, wi);
    // 1 - z, so that sin^2 = (1 - z)(1 + z) keeps its digits.
    const Real down = xi.v * (l + wi.z * (above / below)), up = l + l - down;
    const Real sine = sqrt(max(down * up, Real(0)));
    const auto phi = turn(xi.u);
    const Vec3<Real> m{sum_of_products(Real(k.ax2), wi.x, Real(sqrt(k.ax2)) * sine, phi.cos),
                       sum_of_products(Real(k.ay2), wi.y, Real(sqrt(k.ay2)) * sine, phi.sin),
                       wi.z + (l - down)};
    return combine(Real(2) * dot(wi, m) / dot(m, m), m, Real(-1), wi);
  }

  // L(w): the length of w with its tangential part scaled by the roughness.
  template <class N>
  static GONIO_INLINE typename N::Real length(const Shape<typename N::WideScalar>& k,
                                              const Vec3<typename N::Real>& w) {
    using Real = typename N::Real;
    using std::sqrt;
    const Real tangential = sum_of_products(Real(k.ax2), w.x * w.x, Real(k.ay2), w.y * w.y);
    return sqrt(multiply_add(w.z, w.z, tangential));
  }
};

}  // namespace gonio
