// toy: a model that only tests know, with parameters that no other model has.
//
//   f = w / pi * t / (q + (1 - q) t),   t = (h.k)^2 = cos^2(theta_d)
//
// At q = 1 it falls off by the square of the half-vector's cosine, towards q = 0 it is a diffuse
// colour w. It has no strategy of its own: samples are drawn by the cosine.
#pragma once

#include <array>
#include <numbers>

#include "gonio/models/description.h"
#include "numeric/type_list.h"
#include "parts/geometry.h"
#include "schema/parameter_values.h"

namespace gonio {

struct Toy {
  static constexpr std::array kParameters{Parameter{.name = "w",
                                                    .meaning = "reflectance where wi is wo",
                                                    .unit = "1",
                                                    .lower = 0,
                                                    .upper = 1,
                                                    .start = 0.5,
                                                    .type = ParameterType::colour},
                                          Parameter{.name = "q",
                                                    .meaning = "how far it falls off",
                                                    .unit = "1",
                                                    .lower = 0.05,
                                                    .upper = 1,
                                                    .start = 0.3,
                                                    .scale = Scale::logarithmic}};
  static constexpr ModelDescription kDescription{.name = "toy",
                                                 .summary = "a model for tests",
                                                 .source = "none",
                                                 .role = Role::specular,
                                                 .parameters = kParameters,
                                                 .fast = {.relative = 2e-6},
                                                 .reference = {.relative = 1e-12}};
  using Kinds = TypeList<Toy>;

  template <class S>
  struct Shape {
    S q, rest;
  };
  template <class S>
  struct Channel {
    S colour;  // w / pi
  };
  template <class N>
  struct Stage {
    typename N::Wide t;
  };
  template <class N>
  struct Refined {
    typename N::Real t;
  };
  template <class N>
  struct Terms {
    typename N::Real share;
  };

  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    return {p.number("q"), S(1) - p.number("q")};
  }
  template <class S>
  static Channel<S> channel(const ParameterValues<S>& p, int c) {
    return {p.colour("w", c) / S(std::numbers::pi)};
  }

  template <class N>
  static GONIO_INLINE Stage<N> stage(const Shape<typename N::WideScalar>&, const Geometry<N>& g) {
    return {g.half.cos2_d()};
  }
  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>&, const Stage<N>& s) {
    return {N::real(s.t)};
  }
  template <class N>
  static GONIO_INLINE Terms<N> terms(const Shape<typename N::WideScalar>& k, const Stage<N>&,
                                     const Refined<N>& r) {
    using Real = typename N::Real;
    return {r.t / (Real(k.q) + Real(k.rest) * r.t)};
  }
  template <class N>
  static GONIO_INLINE typename N::Real eval(const Terms<N>& t,
                                            const Channel<typename N::WideScalar>&,
                                            const Channel<typename N::RealScalar>& c) {
    return typename N::Real(c.colour) * t.share;
  }
};

}  // namespace gonio
