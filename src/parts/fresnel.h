// Fresnel reflectance, as a part that microfacet models share.
//
// Each kind offers Channel<S> (its constants of one colour channel), Refined<N> and Terms<N> (what
// depends on the directions only, in two steps as in lobe.h) and reflectance<N>(terms, wide, real),
// which takes the channel's constants in both types.
// All take cos(theta_d) = h.k, the angle at the microfacet, never n.k. Sources: Schlick 1994, eq.
// 15; Born & Wolf, "Principles of Optics", 1.5.2 and 14.2.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "gonio/models/description.h"
#include "numeric/inline.h"
#include "parts/geometry.h"
#include "schema/parameter_values.h"
#include "schema/presets.h"

namespace gonio::fresnel {

inline constexpr std::array<std::string_view, 4> kWords{"none", "schlick", "dielectric",
                                                        "conductor"};

inline constexpr std::array<std::string_view, 1> kSchlickOnly{"schlick"};
inline constexpr std::array<std::string_view, 2> kIndexed{"dielectric", "conductor"};
inline constexpr std::array<std::string_view, 1> kConductorOnly{"conductor"};

inline constexpr Parameter kTerm{
    .name = "fresnel",
    .meaning = "reflectance of a microfacet; if not given, it follows from f0, eta and k",
    .unit = "1",
    .type = ParameterType::word,
    .words = kWords,
    .fit_word = "dielectric"};
inline constexpr Parameter kF0{.name = "f0",
                               .meaning = "reflectance at normal incidence",
                               .unit = "1",
                               .lower = 0,
                               .upper = 1,
                               .start = 0.04,
                               .type = ParameterType::colour,
                               .used_with = {"fresnel", kSchlickOnly},
                               .presets = presets::kReflectance,
                               .dependence = Dependence::affine};
inline constexpr Parameter kEta{.name = "eta",
                                .meaning = "refractive index relative to the outside",
                                .unit = "1",
                                .lower = 0.01,
                                .upper = 100,
                                .start = 1.5,
                                .scale = Scale::logarithmic,
                                .type = ParameterType::colour,
                                .used_with = {"fresnel", kIndexed},
                                .presets = presets::kIndex,
                                .preset_partner = "k",
                                .quantity = Quantity::refractive_index};
inline constexpr Parameter kK{.name = "k",
                              .meaning = "extinction coefficient",
                              .unit = "1",
                              .lower = 0,
                              .upper = 100,
                              .start = 0,
                              .type = ParameterType::colour,
                              .used_with = {"fresnel", kConductorOnly},
                              .presets = presets::kExtinction,
                              .preset_partner = "eta",
                              .quantity = Quantity::extinction};

// F = 1.
struct None {
  template <class S>
  struct Channel {};
  template <class S>
  static Channel<S> channel(const ParameterValues<S>&, int) {
    return {};
  }
  template <class N>
  struct Refined {};
  template <class N>
  struct Terms {};
  template <class N>
  static GONIO_INLINE Refined<N> refine(const HalfVector<N>&) {
    return {};
  }
  template <class N>
  static GONIO_INLINE Terms<N> terms(const Refined<N>&) {
    return {};
  }
  template <class N>
  static GONIO_INLINE typename N::Real reflectance(const Terms<N>&,
                                                   const Channel<typename N::WideScalar>&,
                                                   const Channel<typename N::RealScalar>&) {
    return 1;
  }
};

// F = f0 + (1 - f0) (1 - h.k)^5.
struct Schlick {
  template <class S>
  struct Channel {
    S f0, rest;  // f0 and 1 - f0
  };
  template <class S>
  static Channel<S> channel(const ParameterValues<S>& p, int c) {
    const S f0 = p.colour("f0", c);
    return {f0, S(1) - f0};
  }
  template <class N>
  struct Refined {
    typename N::Real cos_d, sin2_d;
  };
  template <class N>
  struct Terms {
    typename N::Real w5;
  };
  template <class N>
  static GONIO_INLINE Refined<N> refine(const HalfVector<N>& half) {
    return {N::root(half.cos2_d()), N::real(half.sin2_d())};
  }
  template <class N>
  static GONIO_INLINE Terms<N> terms(const Refined<N>& g) {
    using Real = typename N::Real;
    const Real w = max(g.sin2_d, Real(0)) / (Real(1) + g.cos_d);  // 1 - h.k without cancelling
    return {(w * w) * (w * w) * w};
  }
  template <class N>
  static GONIO_INLINE typename N::Real reflectance(const Terms<N>& t,
                                                   const Channel<typename N::WideScalar>&,
                                                   const Channel<typename N::RealScalar>& c) {
    using Real = typename N::Real;
    return Real(c.f0) + Real(c.rest) * t.w5;
  }
};

// Exact unpolarised reflectance of a dielectric. With c = h.k and g^2 = eta^2 - 1 + c^2, the s and
// p amplitudes are written with the factor eta^2 - 1 taken out, so that nothing cancels as eta
// tends to 1; g^2 <= 0 reflects all. g^2 itself comes from the smaller of c^2 and s^2 = 1 - c^2,
// which has the more digits.
struct Dielectric {
  template <class S>
  struct Channel {
    S eta2;            // eta^2
    S eta2_minus_one;  // (eta - 1)(eta + 1)
  };
  template <class S>
  static Channel<S> channel(const ParameterValues<S>& p, int c) {
    const S eta = p.colour("eta", c);
    return {eta * eta, (eta - S(1)) * (eta + S(1))};
  }
  template <class N>
  struct Refined {
    typename N::Wide c2, s2;
  };
  template <class N>
  struct Terms {
    typename N::Wide c2, s2;
    typename N::Real c;
  };
  template <class N>
  static GONIO_INLINE Refined<N> refine(const HalfVector<N>& half) {
    return {half.cos2_d(), half.sin2_d()};
  }
  template <class N>
  static GONIO_INLINE Terms<N> terms(const Refined<N>& g) {
    return {g.c2, g.s2, N::root(g.c2)};
  }
  template <class N>
  static GONIO_INLINE typename N::Real reflectance(const Terms<N>& t,
                                                   const Channel<typename N::WideScalar>& k,
                                                   const Channel<typename N::RealScalar>& real) {
    using Real = typename N::Real;
    using Wide = typename N::Wide;
    const Wide g2 = select(t.c2 < t.s2, Wide(k.eta2_minus_one) + t.c2, Wide(k.eta2) - t.s2);
    const Real g = N::root(max(g2, Wide(0)));
    const Real difference(real.eta2_minus_one), eta2(real.eta2);
    const Real sum = max(t.c + g, Real(1e-18));  // its square stays representable
    const Real mixed = max(eta2 * t.c + g, Real(1e-18));
    const Real s = difference / (sum * sum);
    const Real p_numerator = N::real(Wide(k.eta2) * t.c2 - t.s2);
    const Real p = difference * p_numerator / (mixed * mixed);
    return select(Wide(0) < g2, Real(0.5) * sum_of_products(s, s, p, p), Real(1));
  }
};

// Exact unpolarised reflectance of a conductor with index eta + i k, in the wide type: a - c
// cancels for weak absorbers.
struct Conductor {
  template <class S>
  struct Channel {
    S offset;     // eta^2 - k^2 - 1
    S two_eta_k;  // 2 eta k
  };
  template <class S>
  static Channel<S> channel(const ParameterValues<S>& p, int c) {
    const S eta = p.colour("eta", c), k = p.colour("k", c);
    return {(eta - S(1)) * (eta + S(1)) - k * k, S(2) * eta * k};
  }
  template <class N>
  struct Refined {
    typename N::Wide c2, s2;
  };
  template <class N>
  struct Terms {
    typename N::Wide c2, s2, c;
  };
  template <class N>
  static GONIO_INLINE Refined<N> refine(const HalfVector<N>& half) {
    return {half.cos2_d(), half.sin2_d()};
  }
  template <class N>
  static GONIO_INLINE Terms<N> terms(const Refined<N>& g) {
    using std::sqrt;
    return {g.c2, g.s2, sqrt(g.c2)};
  }
  template <class N>
  static GONIO_INLINE typename N::Real reflectance(const Terms<N>& t,
                                                   const Channel<typename N::WideScalar>& k,
                                                   const Channel<typename N::RealScalar>&) {
    using Wide = typename N::Wide;
    const Wide real_part = Wide(k.offset) + t.c2;  // eta^2 - k^2 - sin^2
    const Wide modulus =
        sqrt(real_part * real_part + Wide(k.two_eta_k * k.two_eta_k));  // a^2 + b^2
    // The larger of a^2, b^2 is a sum; the other follows from a b = eta k.
    const Wide larger = max(Wide(0.5) * (modulus + max(real_part, -real_part)), Wide(1e-300));
    const Wide smaller = Wide(0.25 * k.two_eta_k * k.two_eta_k) / larger;
    const auto positive = Wide(0) < real_part;
    const Wide a2 = select(positive, larger, smaller);
    const Wide b2 = select(positive, smaller, larger);
    const Wide a = sqrt(a2);
    const Wide minus = a - t.c, plus = a + t.c;
    const Wide rs = (minus * minus + b2) / (plus * plus + b2);
    const Wide ac = a * t.c;
    const Wide p_minus = ac - t.s2, p_plus = ac + t.s2;
    const Wide rp =
        sum_of_products(p_minus, p_minus, b2, t.c2) / sum_of_products(p_plus, p_plus, b2, t.c2);
    return N::real(Wide(0.5) * rs * (Wide(1) + rp));
  }
};

}  // namespace gonio::fresnel
