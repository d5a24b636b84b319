// phong: a power of the cosine to the mirror direction, normalised.
//
//   f = scale (s + 2) / (2 pi) max(0, wr.wo)^s F(h.k),   wr the mirror image of wi
//
// Sources: Phong 1975, "Illumination for Computer Generated Pictures"; in this form Nielsen,
// Frisvad, Conradsen & Aanaes 2014, equation 1. The cosine is clamped at 0, which the print leaves
// out: over a third of the hemisphere it is negative. Stable forms: parts/cosine_power.h.
#pragma once

#include <array>
#include <numbers>

#include "gonio/models/description.h"
#include "parts/cosine_power.h"
#include "parts/lobe.h"
#include "parts/mirror_sampling.h"

namespace gonio {

struct Phong : AimedBy<MirrorAim> {
  static constexpr auto kParameters = with_fresnel(cosine_power::kExponent);
  static constexpr ModelDescription kDescription{
      .name = "phong",
      .summary = "a power of the cosine to the mirror direction",
      .source = "Phong 1975; Nielsen, Frisvad, Conradsen & Aanaes 2014, eq. 1",
      .role = Role::specular,
      .parameters = kParameters,
      .fast = {.relative = 3e-6},
      .reference = {.relative = 3e-9, .note = "3e-11 for exponents up to 1000"}};
  using Kinds = FresnelKinds<Phong>;

  template <class S>
  struct Shape {
    S minus_s, of_zero, norm;
  };

  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    const S s = p.number("s");
    return {-s, cosine_power::log2_of_zero(s), (s + S(2)) / S(2 * std::numbers::pi)};
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
    return {N::exp2(
        cosine_power::of_base<N>(k.minus_s, k.of_zero, mirror.cos, mirror.one_minus_cos(half)))};
  }

  template <class N>
  static GONIO_INLINE typename N::Real amplitude(const Shape<typename N::WideScalar>& k,
                                                 const Stage<N>&, const Refined<N>& r) {
    return N::times_exp2(typename N::Real(k.norm), r.power);
  }

  // Sampling: (s+1)/(2 pi) (wr.wo)^s, nothing of it below the horizon.
  template <class N>
  static GONIO_INLINE typename N::Real pdf(const Shape<typename N::WideScalar>& k,
                                           const HalfVector<N>&, const Stage<N>&,
                                           const Refined<N>& r, const Aim<N>& aim) {
    const double width = 0.5 - 0.5 * k.minus_s;
    return N::times_exp2(
        typename N::Real(width * 0.318309886183790672) * aim.gain(PowerProfile<N>(width)), r.power);
  }

  template <class N>
  static GONIO_INLINE Vec3<typename N::Real> sample(const Shape<typename N::WideScalar>& k,
                                                    const Vec3<typename N::Real>& wi,
                                                    const Xi<typename N::Real>& xi) {
    return draw_about_mirror<N>(PowerProfile<N>(0.5 - 0.5 * k.minus_s), wi, xi.u, xi.v);
  }
};

}  // namespace gonio
