// blinn_phong: a power of the cosine between normal and half-vector, normalised exactly.
//
//   f = scale (s + 2)(s + 4) / (8 pi (2^(-s/2) + s)) (n.h)^s F(h.k)
//
// Sources: Blinn 1977, "Models of Light Reflection for Computer Synthesized Pictures"; Nielsen,
// Frisvad, Conradsen & Aanaes 2014, equation 2, whose (s + 8) / (8 pi) is an approximation by which
// the albedo reaches 1.075; the factor here makes it 1 at normal incidence. Stable forms:
// parts/cosine_power.h.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "gonio/models/description.h"
#include "parts/cosine_power.h"
#include "parts/half_vector_sampling.h"
#include "parts/lobe.h"

namespace gonio {

struct BlinnPhong : AimedBy<HalfVectorAim> {
  static constexpr auto kParameters = with_fresnel(cosine_power::kExponent);
  static constexpr ModelDescription kDescription{
      .name = "blinn_phong",
      .summary = "a power of the cosine between normal and half-vector",
      .source = "Blinn 1977; Nielsen, Frisvad, Conradsen & Aanaes 2014, eq. 2 with the exact norm",
      .role = Role::specular,
      .parameters = kParameters,
      .fast = {.relative = 3e-6, .note = cosine_power::kFastNote},
      .reference = {.relative = 3e-9, .note = cosine_power::kReferenceNote}};
  using Kinds = FresnelKinds<BlinnPhong>;

  template <class S>
  struct Shape {
    S minus_half_s, norm;
  };

  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    using std::exp2;
    const S s = p.number("s"), half = S(-0.5) * s;
    return {half, (s + S(2)) * (s + S(4)) / (S(8 * std::numbers::pi) * (exp2(half) + s))};
  }

  template <class N>
  struct Stage {};

  template <class N>
  static GONIO_INLINE Stage<N> stage(const Shape<typename N::WideScalar>&, const Geometry<N>&) {
    return {};
  }

  template <class N>
  struct Refined {
    typename N::Power power;
  };

  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>& k,
                                        const HalfVector<N>& half, const Stage<N>&) {
    return {N::exp2(cosine_power::of_half_vector<N>(k.minus_half_s, half))};
  }

  template <class N>
  static GONIO_INLINE typename N::Real amplitude(const Shape<typename N::WideScalar>& k,
                                                 const Stage<N>&, const Refined<N>& r) {
    return N::times_exp2(typename N::Real(k.norm), r.power);
  }

  // Sampling: half-vectors by (s+1)/(2 pi) (n.h)^s, none that reflects below the horizon.
  template <class N>
  static GONIO_INLINE typename N::Real pdf(const Shape<typename N::WideScalar>& k,
                                           const HalfVector<N>&, const Stage<N>&,
                                           const Refined<N>& r, const Aim<N>& aim) {
    const double width = 0.5 - k.minus_half_s;
    return N::times_exp2(
        typename N::Real(width * 0.318309886183790672) * aim.gain(PowerProfile<N>(width)), r.power);
  }

  template <class N>
  static GONIO_INLINE Vec3<typename N::Real> sample(const Shape<typename N::WideScalar>& k,
                                                    const Vec3<typename N::Real>& wi,
                                                    const Xi<typename N::Real>& xi) {
    using Real = typename N::Real;
    const auto phi = half_turn(xi.u);
    return draw_by_half_vector<N>(PowerProfile<N>(0.5 - k.minus_half_s),
                                  Tangent<Real>{phi.cos, phi.sin}, wi, xi.v);
  }
};

}  // namespace gonio
