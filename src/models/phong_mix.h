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

#include "gonio/models/description.h"
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
  static constexpr auto kParameters = with_fresnel(cosine_power::kExponent, kMix);
  static constexpr ModelDescription kDescription{
      .name = "phong_mix",
      .summary = "a power of a mean of Phong's cosine and the half-vector's, not normalised",
      .source = "Nielsen, Frisvad, Conradsen & Aanaes 2014, eq. 3",
      .role = Role::specular,
      .parameters = kParameters,
      .fast = {.relative = 3e-6, .note = cosine_power::kFastNote},
      .reference = {.relative = 3e-9, .note = cosine_power::kReferenceNote},
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
    typename N::Power power;
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
    return {N::exp2(cosine_power::of_base<N>(k.minus_s, k.of_zero, base, one_minus_base))};
  }

  template <class N>
  static GONIO_INLINE typename N::Real amplitude(const Shape<typename N::WideScalar>&,
                                                 const Stage<N>&, const Refined<N>& r) {
    return N::times_exp2(typename N::Real(1), r.power);
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
  static GONIO_INLINE typename N::Real pdf(const Shape<typename N::WideScalar>& k,
                                           const HalfVector<N>&, const Stage<N>&, const Refined<N>&,
                                           const Aim<N>& aim) {
    using Real = typename N::Real;
    const double mirror_width = 0.5 - 0.5 * k.minus_s, half_width = 0.5 - 2 * k.minus_s;
    const Real mirror_gain = aim.mirror.gain(PowerProfile<N>(mirror_width));
    const Real half_gain = aim.half.gain(PowerProfile<N>(half_width));
    const Real of_mirror =
        exp2_of(Real(-k.minus_s) * log2_of_rest(aim.mirror.away, aim.mirror.cosine)).power;
    const Real across2 = aim.half.x2 + aim.half.y2;
    const Real inverse = Real(1) / max(across2 + aim.half.hz2, Real(1e-30));
    const Real of_half =
        exp2_of(Real(-2 * k.minus_s) * log2_of_rest(across2 * inverse, aim.half.hz2 * inverse))
            .power;
    constexpr double kInversePi = 0.318309886183790672;
    return sum_of_products(Real(kInversePi * k.rest * mirror_width) * mirror_gain, of_mirror,
                           Real(kInversePi * k.mix * half_width) * half_gain, of_half);
  }

  // Both lobes at once: an axis, how far it reaches on its shorter side, a place along it.
  template <class N>
  static GONIO_INLINE Vec3<typename N::Real> sample(const Shape<typename N::WideScalar>& k,
                                                    const Vec3<typename N::Real>& wi,
                                                    const Xi<typename N::Real>& xi) {
    using Real = typename N::Real;
    const auto by_half = xi.choice < Real(k.mix);
    const auto either = [&](const Real& half, const Real& mirror) {
      return select(by_half, half, mirror);
    };
    const double mirror_width = 0.5 - 0.5 * k.minus_s, half_width = 0.5 - 2 * k.minus_s;
    const PowerProfile<N> profile(either(half_width, mirror_width),
                                  either(1 / half_width, 1 / mirror_width));
    const auto phi = half_turn(xi.u);
    const Tangent<Real> axis{phi.cos, phi.sin};
    const MirrorAxis<Real> about(axis, wi);
    const Colatitude<Real> fall = about.limit(wi);
    const Real toward = sum_of_products(wi.x, axis.x, wi.y, axis.y);
    const Colatitude<Real> lit = reach(toward, wi.z * wi.z);
    const Real longer = either(profile.mass_beyond_45(lit), 1);
    const Real shorter =
        profile.mass(Colatitude<Real>{either(lit.cos2, fall.sin2), either(lit.sin2, fall.cos2)});
    const auto longer_first = Real(0) < either(toward, axis.x);
    const Along<Real> place =
        along(xi.v, select(longer_first, longer, shorter), select(longer_first, shorter, longer));
    const Colatitude<Real> angle = profile.at(place.mass);
    const Vec3<Real> a = reflected(wi, axis, toward, angle, place.sign);
    const Vec3<Real> b = about.direction(wi, angle, place.sign);
    return {either(a.x, b.x), either(a.y, b.y), either(a.z, b.z)};
  }
};

}  // namespace gonio
