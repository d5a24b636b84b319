// ashikhmin_shirley: the anisotropic Phong model, with the diffuse term of its own that keeps
// energy.
//
//   f_s = scale sqrt((nu+1)(nv+1)) / (8 pi) * (n.h)^e / ((h.k) max(n.wi, n.wo)) * F,   F Schlick
//   with f0 = rs,
//         e = (nu hx^2 + nv hy^2) / (hx^2 + hy^2)
//   f_d = 28 rd / (23 pi) (1 - rs) (1 - (1 - n.wi/2)^5) (1 - (1 - n.wo/2)^5)
//
// Source: Ashikhmin & Shirley 2000, "An Anisotropic Phong BRDF Model", equations 4 and 5.
// Stable forms: (n.h)^e = 2^(-e/2 log2(1 + s/c)) with s = Hx^2 + Hy^2, c = Hz^2 of H = wi + wo,
// whose logarithm is exact to the last digits near h = n; there e is 0/0, but bounded by nu and nv,
// and the logarithm 0; 1 - (1 - w)^5 = w (5 - 10w + 10w^2 - 5w^3 + w^4), w = n.k/2, does not cancel
// at grazing.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "gonio/models/description.h"
#include "numeric/type_list.h"
#include "parts/cosine_power.h"
#include "parts/fresnel.h"
#include "parts/geometry.h"
#include "parts/half_vector_sampling.h"
#include "parts/lobe.h"
#include "schema/parameter_values.h"
#include "schema/presets.h"

namespace gonio {

struct AshikhminShirley : AimedBy<HalfVectorAim> {
  static constexpr std::array kParameters{
      Parameter{.name = "rd",
                .meaning = "diffuse colour",
                .unit = "1",
                .lower = 0,
                .upper = 1,
                .start = 0,
                .type = ParameterType::colour,
                .quantity = Quantity::base,
                .dimmed_by = "rs"},
      Parameter{.name = "rs",
                .meaning = "specular reflectance at normal incidence",
                .unit = "1",
                .lower = 0,
                .upper = 1,
                .start = 0.5,
                .type = ParameterType::colour,
                .presets = presets::kReflectance,
                .dependence = Dependence::affine},
      Parameter{.name = "nu",
                .meaning = "exponent along the tangent u",
                .unit = "1",
                .lower = 0,
                .upper = 1e8,
                .start = 100,
                .scale = Scale::logarithmic},
      Parameter{.name = "nv",
                .meaning = "exponent along the tangent v",
                .unit = "1",
                .lower = 0,
                .upper = 1e8,
                .start = 100,
                .scale = Scale::logarithmic},
      kScale};
  static constexpr ModelDescription kDescription{
      .name = "ashikhmin_shirley",
      .summary =
          "anisotropic Phong lobe of the half-vector with Schlick's Fresnel and an energy-keeping "
          "diffuse term",
      .source = "Ashikhmin & Shirley 2000, An Anisotropic Phong BRDF Model, eq. 4, 5",
      .role = Role::specular,
      .parameters = kParameters,
      .fast = {.relative = 3e-6, .note = cosine_power::kFastNote},
      .reference = {.relative = 3e-9, .note = cosine_power::kReferenceNote},
      .along_tangents = {"nu", "nv"}};
  using Kinds = TypeList<AshikhminShirley>;

  template <class S>
  struct Shape {
    S minus_half_nu, minus_half_nv, norm;
  };
  template <class S>
  struct Channel {
    S specular, specular_rest, diffuse;  // scale rs, scale (1 - rs), 28 rd (1 - rs) / (23 pi)
  };
  template <class N>
  struct Stage {
    HalfVector<N> half;
    typename N::Real cos_i, cos_o;
  };
  template <class N>
  struct Refined {
    typename N::Power power;      // (n.h)^e
    typename N::Real h2, sin2_d;  // |H|^2
  };
  template <class N>
  struct Terms {
    typename N::Real amplitude, w5, diffuse;
  };

  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    using std::sqrt;
    const S nu = p.number("nu"), nv = p.number("nv");
    return {S(-0.5) * nu, S(-0.5) * nv, sqrt((nu + S(1)) * (nv + S(1))) / S(8 * std::numbers::pi)};
  }

  template <class S>
  static Channel<S> channel(const ParameterValues<S>& p, int c) {
    const S rd = p.colour("rd", c), rs = p.colour("rs", c), scale = p.colour("scale", c);
    return {scale * rs, scale * (S(1) - rs), S(28 / (23 * std::numbers::pi)) * rd * (S(1) - rs)};
  }

  template <class N>
  static GONIO_INLINE Stage<N> stage(const Shape<typename N::WideScalar>&, const Geometry<N>& g) {
    return {g.half, g.cos_i(), g.cos_o()};
  }

  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>& k, const Stage<N>& g) {
    using Wide = typename N::Wide;
    const Vec3<Wide>& h = g.half.h;
    const Wide x2 = h.x * h.x, y2 = h.y * h.y, c = h.z * h.z;
    const Wide weighted = sum_of_products(Wide(k.minus_half_nu), x2, Wide(k.minus_half_nv), y2);
    const Wide h2 = g.half.length2();
    return {N::exp2(N::weighted_log2_1p(weighted, x2 + y2, c, h2)), N::real(h2),
            N::real(g.half.sin2_d())};
  }

  template <class N>
  static GONIO_INLINE Terms<N> terms(const Shape<typename N::WideScalar>& k, const Stage<N>& g,
                                     const Refined<N>& r) {
    using Real = typename N::Real;
    using std::sqrt;
    const Real cos_d = Real(0.5) * sqrt(r.h2);
    // The bound, far beyond the horizon's stated limit, keeps the amplitude finite.
    const Real below = max(cos_d * max(g.cos_i, g.cos_o), Real(1e-29));
    // One division for 1/below and for 1 - cos_d = sin^2 / (1 + cos_d).
    const Real beside = Real(1) + cos_d, inverse = Real(1) / (below * beside);
    const Real w = max(r.sin2_d, Real(0)) * (below * inverse);
    return {N::times_exp2(Real(k.norm) * (beside * inverse), r.power), (w * w) * (w * w) * w,
            falloff(g.cos_i) * falloff(g.cos_o)};
  }

  // 1 - (1 - cos/2)^5.
  template <class Real>
  static GONIO_INLINE Real falloff(Real cos) {
    return cos * (Real(5. / 2) -
                  cos * (Real(5. / 2) -
                         cos * (Real(5. / 4) - cos * (Real(5. / 16) - cos * Real(1. / 32)))));
  }

  // Sampling: the paper's half-vectors (its equations 6 to 8, by one continuous map of the azimuth
  // in the place of four), but none that reflects below the horizon. The diffuse term is left to
  // the cosine.
  using Drawn = AshikhminShirley;
  template <class N>
  static GONIO_INLINE typename N::Real pdf(const Shape<typename N::WideScalar>& k, const Stage<N>&,
                                           const Refined<N>& r, const Aim<N>& aim) {
    using Real = typename N::Real;
    const Real half_e = aim.by_azimuth(Real(-k.minus_half_nu), Real(-k.minus_half_nv));
    const PowerProfile<N> profile(half_e + Real(0.5));
    return N::times_exp2(Real(4 * k.norm) * aim.gain(profile), r.power);
  }

  template <class N>
  static GONIO_INLINE Vec3<typename N::Real> sample(const Shape<typename N::WideScalar>& k,
                                                    const Vec3<typename N::Real>& wi,
                                                    const Xi<typename N::Real>& xi) {
    using Real = typename N::Real;
    using std::sqrt;
    const Real half_nu = Real(-k.minus_half_nu), half_nv = Real(-k.minus_half_nv);
    const auto at = half_turn(xi.u);
    const auto phi =
        unit_tangent(sqrt(half_nv + Real(0.5)) * at.cos, sqrt(half_nu + Real(0.5)) * at.sin);
    const Real half_e = sum_of_products(half_nu, phi.x * phi.x, half_nv, phi.y * phi.y);
    return draw_by_half_vector<N>(PowerProfile<N>(half_e + Real(0.5)), phi, wi, xi.v);
  }

  template <class N>
  static GONIO_INLINE typename N::Real eval(const Terms<N>& t,
                                            const Channel<typename N::WideScalar>&,
                                            const Channel<typename N::RealScalar>& c) {
    using Real = typename N::Real;
    return sum_of_products(t.amplitude, Real(c.specular) + Real(c.specular_rest) * t.w5,
                           Real(c.diffuse), t.diffuse);
  }
};

}  // namespace gonio
