// oren_nayar: a rough diffuse surface of V-shaped Lambertian facets, sigma their slope's standard
// deviation as an angle.
//
//   full:  f = rd/pi [C1 + cos(dphi) C2 tan(beta) + (1 - |cos(dphi)|) C3 tan((alpha + beta)/2)]
//              + .17 rd^2/pi s2/(s2 + .13) [1 - cos(dphi) (2 beta/pi)^2],    s2 = sigma^2
//          C1 = 1 - .5 s2/(s2 + .33),   C3 = .125 s2/(s2 + .09) (4 alpha beta/pi^2)^2
//          C2 = .45 s2/(s2 + .09) (sin(alpha) - (2 beta/pi)^3 where cos(dphi) < 0)
//   short: f = rd/pi [C1 + .45 s2/(s2 + .09) max(0, cos(dphi)) sin(alpha) tan(beta)]
//
// with alpha and beta the larger and the smaller polar angle and dphi the azimuth between. Source:
// Oren & Nayar 1994, "Generalization of Lambert's Reflectance Model", equations 26 to 30. The full
// form is a fit: for sigma of .8 and more it is negative at low albedo (clamped at 0 here), and
// at grazing angles it reaches albedo 1.044.
//
// Stable forms: cos(dphi) sin(alpha) tan(beta) = (wi.wo - n.wi n.wo) / max(n.wi, n.wo);
// tan((alpha + beta)/2) = (sin(alpha) + sin(beta)) / (cos(alpha) + cos(beta)); sin(alpha) -
// (2 beta/pi)^3 from the complement u = 1 - 2 beta/pi, or at grazing tan(beta) would meet a
// difference of ones; 1 - |cos(dphi)| from the sine of dphi.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "gonio/models/description.h"
#include "numeric/type_list.h"
#include "parts/geometry.h"
#include "schema/parameter_values.h"

namespace gonio {

struct OrenNayar {
  static constexpr std::array<std::string_view, 2> kForms{"full", "short"};
  static constexpr std::array<std::string_view, 1> kFull{"full"};
  static constexpr std::array kParameters{
      Parameter{.name = "rd",
                .meaning = "diffuse albedo of a facet",
                .unit = "1",
                .lower = 0,
                .upper = 1,
                .start = 0.5,
                .type = ParameterType::colour,
                .dependence = Dependence::quadratic,
                .dependence_with = {"form", kFull}},
      Parameter{.name = "sigma",
                .meaning = "standard deviation of the facets' slope angle",
                .unit = "rad",
                .lower = 0,
                .upper = 1.5707963267948966,
                .start = 0.3},
      Parameter{.name = "form",
                .meaning = "with light that two facets reflect in turn, or without",
                .unit = "1",
                .type = ParameterType::word,
                .words = kForms}};
  static constexpr std::string_view kNote =
      "full form, where it crosses 0: four roundings of rd and sigma";
  static constexpr std::array<std::string_view, 2> kCrossing{"rd", "sigma"};
  static constexpr ModelDescription kDescription{
      .name = "oren_nayar",
      .summary = "rough diffuse reflection of V-shaped facets",
      .source = "Oren & Nayar 1994, Generalization of Lambert's Reflectance Model, eq. 26-30",
      .role = Role::diffuse,
      .parameters = kParameters,
      .fast = {.relative = 3e-6, .note = kNote},
      .reference = {.relative = 3e-11, .note = kNote},
      .albedo_limit = 1.06,
      .crossing = kCrossing};

  template <class S>
  struct Channel {
    S once, twice;  // rd/pi, .17 rd^2/pi s2/(s2 + .13)
  };

  template <class S>
  static Channel<S> channel(const ParameterValues<S>& p, int c) {
    const S rd = p.colour("rd", c), sigma = p.number("sigma"), s2 = sigma * sigma;
    const S once = rd / S(std::numbers::pi);
    return {once, S(0.17) * once * rd * (s2 / (s2 + S(0.13)))};
  }

  template <class S>
  struct Shape {
    S c1, c2, c3;  // without their angles
  };

  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    const S sigma = p.number("sigma"), s2 = sigma * sigma, ratio = s2 / (s2 + S(0.09));
    return {S(1) - S(0.5) * (s2 / (s2 + S(0.33))), S(0.45) * ratio, S(0.125) * ratio};
  }

  // What both forms take of a pair.
  template <class N>
  struct Stage {
    typename N::Wide across, turned;    // cos(dphi) and sin(dphi), times sin(alpha) sin(beta)
    typename N::Wide sine2_i, sine2_o;  // squares of the sines
    typename N::Wide cos_i, cos_o;
  };

  template <class N>
  static GONIO_INLINE Stage<N> stage(const Shape<typename N::WideScalar>&, const Geometry<N>& g) {
    return {sum_of_products(g.wi.x, g.wo.x, g.wi.y, g.wo.y),
            sum_of_products(g.wi.x, g.wo.y, -g.wi.y, g.wo.x),
            sum_of_products(g.wi.x, g.wi.x, g.wi.y, g.wi.y),
            sum_of_products(g.wo.x, g.wo.x, g.wo.y, g.wo.y),
            g.wi.z,
            g.wo.z};
  }

  // What a form refines are its terms.
  template <class N, class Refined>
  static GONIO_INLINE Refined terms(const Shape<typename N::WideScalar>&, const Stage<N>&,
                                    const Refined& r) {
    return r;
  }

  struct Full;
  struct Short;
  using Kinds = TypeList<Full, Short>;
};

struct OrenNayar::Short : OrenNayar {
  template <class N>
  struct Refined {
    typename N::Real once;
  };
  template <class N>
  using Terms = Refined<N>;

  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>& k, const Stage<N>& s) {
    using Wide = typename N::Wide;
    const Wide most = max(max(s.cos_i, s.cos_o), Wide(1e-30));
    return {N::real(Wide(k.c1) + Wide(k.c2) * (max(s.across, Wide(0)) / most))};
  }
  template <class N>
  static GONIO_INLINE typename N::Real eval(const Terms<N>& t,
                                            const Channel<typename N::WideScalar>&,
                                            const Channel<typename N::RealScalar>& c) {
    return typename N::Real(c.once) * t.once;
  }
};

struct OrenNayar::Full : OrenNayar {
  template <class N>
  struct Refined {
    typename N::Real once, twice;  // the factors of rd and of rd^2
  };
  template <class N>
  using Terms = Refined<N>;

  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>& k, const Stage<N>& s) {
    using Wide = typename N::Wide;
    using std::sqrt;
    constexpr double kTwoOverPi = 0.636619772367581343;
    const auto i_lower = s.cos_i < s.cos_o;
    const Wide sin_a = sqrt(select(i_lower, s.sine2_i, s.sine2_o));
    const Wide sin_b = sqrt(select(i_lower, s.sine2_o, s.sine2_i));
    const Wide cos_a = min(s.cos_i, s.cos_o), cos_b = max(max(s.cos_i, s.cos_o), Wide(1e-30));
    // u = 1 - 2 angle/pi, small at grazing.
    const Wide ua = Wide(kTwoOverPi) * N::angle(cos_a, sin_a),
               ub = Wide(kTwoOverPi) * N::angle(cos_b, sin_b);
    const Wide va = Wide(1) - ua, vb = Wide(1) - ub;
    const Wide sines = max(sin_a * sin_b, Wide(1e-30)), size = max(s.across, -s.across);
    const Wide cos_phi = max(min(s.across / sines, Wide(1)), Wide(-1));
    // 1 - |cos(dphi)|
    const Wide to_side = min(s.turned * s.turned / (sines * (sines + size)), Wide(1));
    const Wide difference =
        ub * (Wide(3) - ub * (Wide(3) - ub)) - cos_a * cos_a / (Wide(1) + sin_a);
    const Wide forward = cos_phi * sin_b * difference / cos_b;
    const Wide second = select(s.across < Wide(0), forward, s.across / cos_b);
    const Wide product = va * vb;
    const Wide third = to_side * (product * product) * ((sin_a + sin_b) / (cos_a + cos_b));
    return {N::real(Wide(k.c1) + sum_of_products(Wide(k.c2), second, Wide(k.c3), third)),
            N::real(Wide(1) - cos_phi * (vb * vb))};
  }
  template <class N>
  static GONIO_INLINE typename N::Real eval(const Terms<N>& t,
                                            const Channel<typename N::WideScalar>&,
                                            const Channel<typename N::RealScalar>& c) {
    using Real = typename N::Real;
    return max(Real(0), sum_of_products(Real(c.once), t.once, Real(c.twice), t.twice));
  }
};

}  // namespace gonio
