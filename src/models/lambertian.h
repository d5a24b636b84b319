// lambertian: the ideal diffuse surface.
//
//   f = rd / pi
//
// Source: Lambert 1760, "Photometria".
#pragma once

#include <array>
#include <numbers>

#include "gonio/models/description.h"
#include "numeric/type_list.h"
#include "parts/geometry.h"
#include "schema/parameter_values.h"

namespace gonio {

struct Lambertian {
  static constexpr std::array kParameters{Parameter{.name = "rd",
                                                    .meaning = "diffuse albedo",
                                                    .unit = "1",
                                                    .lower = 0,
                                                    .upper = 1,
                                                    .start = 0.5,
                                                    .type = ParameterType::colour}};
  static constexpr ModelDescription kDescription{.name = "lambertian",
                                                 .summary = "ideal diffuse reflection",
                                                 .source = "Lambert 1760, Photometria",
                                                 .role = Role::diffuse,
                                                 .parameters = kParameters,
                                                 .fast = {.relative = 2e-7},
                                                 .reference = {.relative = 1e-15}};
  using Kinds = TypeList<Lambertian>;

  template <class S>
  struct Shape {};
  template <class S>
  struct Channel {
    S value;
  };
  template <class N>
  struct Stage {};
  template <class N>
  struct Refined {};
  template <class N>
  struct Terms {};

  template <class S>
  static Shape<S> shape(const ParameterValues<S>&) {
    return {};
  }
  template <class S>
  static Channel<S> channel(const ParameterValues<S>& p, int c) {
    return {p.colour("rd", c) / S(std::numbers::pi)};
  }

  template <class N>
  static GONIO_INLINE Stage<N> stage(const Shape<typename N::WideScalar>&, const Geometry<N>&) {
    return {};
  }
  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>&, const Stage<N>&) {
    return {};
  }
  template <class N>
  static GONIO_INLINE Terms<N> terms(const Shape<typename N::WideScalar>&, const Stage<N>&,
                                     const Refined<N>&) {
    return {};
  }
  template <class N>
  static GONIO_INLINE typename N::Real eval(const Terms<N>&, const Channel<typename N::WideScalar>&,
                                            const Channel<typename N::RealScalar>& c) {
    return typename N::Real(c.value);
  }
};

}  // namespace gonio
