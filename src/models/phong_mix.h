// phong_mix: a power of the mean of Phong's cosine and of the half-vector's, whose lobe changes
// from round to long towards grazing angles as that of measured materials does.
//
//   f = scale [(1 - mix) max(0, wr.wo) + mix (n.h)^4]^s F(h.k),   wr the mirror image of wi
//
// Source: Nielsen, Frisvad, Conradsen & Aanaes 2014, equation 3, with the cosine clamped at 0. It
// is not normalised; a small s gains energy (albedo pi at s = 0). Stable forms:
// parts/cosine_power.h; 1 - (n.h)^4 = (1 - cos^2)(1 + cos^2).
#pragma once

#include <array>

#include "models/description.h"
#include "parts/cosine_power.h"
#include "parts/half_vector_sampling.h"
#include "parts/lobe.h"
#include "parts/mirror_sampling.h"

namespace gonio {

struct PhongMix {
  static constexpr Parameter kMix{.name = "mix",
                                  .meaning = "share of the half-vector's cosine in the base",
                                  .unit = "1",
                                  .lower = 0,
                                  .upper = 1,
                                  .start = 0.5};
  static constexpr std::array kParameters{
      cosine_power::kExponent, kMix,        fresnel::kKind, fresnel::kF0,
      fresnel::kEta,           fresnel::kK, kScale};
  static constexpr ModelDescription kDescription{
      .name = "phong_mix",
      .summary = "a power of a mean of Phong's cosine and the half-vector's, not normalised",
      .source = "Nielsen, Frisvad, Conradsen & Aanaes 2014, eq. 3",
      .role = Role::specular,
      .parameters = kParameters,
      .fast = {.relative = 3e-6},
      .reference = {.relative = 3e-9, .note = "3e-11 for exponents up to 1000"},
      .albedo_limit = 3.1416};
  using Kinds = FresnelKinds<PhongMix>;

  template <class S>
  struct Shape {
    S minus_s, of_zero, mix, rest;
  };

  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    const S s = p.number("s"), mix = p.number("mix");
    return {-s, cosine_power::log2_of_zero(s), mix, S(1) - mix};
  }

  template <class N>
  using Stage = cosine_power::Mirror<N>;

  template <class N>
  static GONIO_INLINE Stage<N> stage(const Shape<typename N::WideScalar>&, const Geometry<N>& g) {
    return Stage<N>(g);
  }

  template <class N>
  struct Refined {
    typename N::Wide exponent;
  };

  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>& k,
                                        const HalfVector<N>& half, const Stage<N>& mirror) {
    using Wide = typename N::Wide;
    const Vec3<Wide>& h = half.h;
    // The addend keeps 0/0 away where wi = -wo and both all but touch the surface.
    const Wide inverse = Wide(1) / (half.length2() + Wide(1e-300));
    const Wide cos2 = h.z * h.z * inverse;
    const Wide sine2 = sum_of_products(h.x, h.x, h.y, h.y) * inverse;
    const Wide mirror_part = select(Wide(0) < mirror.cos, mirror.one_minus_cos(half), Wide(1));
    const Wide base =
        sum_of_products(Wide(k.rest), max(mirror.cos, Wide(0)), Wide(k.mix), cos2 * cos2);
    const Wide one_minus_base =
        sum_of_products(Wide(k.rest), mirror_part, Wide(k.mix), sine2 * (Wide(1) + cos2));
    return {cosine_power::of_base<N>(k.minus_s, k.of_zero, base, one_minus_base)};
  }

  template <class N>
  static GONIO_INLINE typename N::Real amplitude(const Shape<typename N::WideScalar>&,
                                                 const Stage<N>&, const Refined<N>& r) {
    return N::times_exp2(typename N::Real(1), r.exponent);
  }

  // Sampling: by the shares 1 - mix and mix, what phong draws for s and what blinn_phong draws for
  // 4 s.
  template <class N>
  struct Aim {
    MirrorAim<N> mirror;
    HalfVectorAim<N> half;
  };

  template <class N>
  static GONIO_INLINE Aim<N> aim(const Shape<typename N::WideScalar>&, const Geometry<N>& g) {
    return {MirrorAim<N>(g), HalfVectorAim<N>(g)};
  }

  template <class N>
  static GONIO_INLINE typename N::Real density(const Shape<typename N::WideScalar>& k,
                                               const HalfVector<N>& half, const Stage<N>& mirror,
                                               const Refined<N>&, const Aim<N>& aim) {
    using Real = typename N::Real;
    const Real mirror_width = Real(0.5 - 0.5 * k.minus_s), half_width = Real(0.5 - 2 * k.minus_s);
    const Real of_mirror = N::times_exp2(
        mirror_width * aim.mirror.gain(PowerProfile<N>{mirror_width}),
        cosine_power::of_base<N>(k.minus_s, k.of_zero, mirror.cos, mirror.one_minus_cos(half)));
    const Real cos_d4 = max(Real(2) * N::root(half.length2()), Real(1e-29));
    const Real of_half =
        N::times_exp2(half_width * aim.half.gain(PowerProfile<N>{half_width}) / cos_d4,
                      cosine_power::of_half_vector<N>(2 * k.minus_s, half));
    return Real(0.318309886183790672) *
           sum_of_products(Real(k.rest), of_mirror, Real(k.mix), of_half);
  }

  template <class N>
  static GONIO_INLINE Vec3<typename N::Real> draw(const Shape<typename N::WideScalar>& k,
                                                  const Vec3<typename N::Real>& wi,
                                                  const Xi<typename N::Real>& xi) {
    using Real = typename N::Real;
    const auto by_half = xi.choice < Real(k.mix);
    const auto phi = turn(Real(0.5) * xi.u);
    const Vec3<Real> a = draw_by_half_vector<N>(PowerProfile<N>{Real(0.5 - 2 * k.minus_s)},
                                                Tangent<Real>{phi.cos, phi.sin}, wi, xi.v);
    const Vec3<Real> b = draw_about_mirror<N>({Real(0.5 - 0.5 * k.minus_s)}, wi, xi.u, xi.v);
    return {select(by_half, a.x, b.x), select(by_half, a.y, b.y), select(by_half, a.z, b.z)};
  }
};

}  // namespace gonio
