// A specular lobe: amplitude(wi, wo) * F(h.k) * scale, the frame that the microfacet models share.
//
// Model gives the amplitude, once for all channels, in three steps: stage(shape, geometry),
// refine(shape, half, stage) and amplitude(shape, stage, refined). Fresnel (parts/fresnel.h) and
// the colour scale differ by channel.
#pragma once

#include <array>

#include "numeric/type_list.h"
#include "parts/fresnel.h"
#include "parts/geometry.h"
#include "schema/parameter_values.h"

namespace gonio {

inline constexpr Parameter kScale{.name = "scale",
                                  .meaning = "colour multiplier of the specular part",
                                  .unit = "1",
                                  .lower = 0,
                                  .upper = 1e6,
                                  .start = 1,
                                  .type = ParameterType::colour,
                                  .quantity = Quantity::amplitude};

// The table of a microfacet model: its own parameters, then those of Fresnel's term and the scale.
template <class... Own>
constexpr std::array<Parameter, sizeof...(Own) + 5> with_fresnel(const Own&... own) {
  return {own..., fresnel::kTerm, fresnel::kF0, fresnel::kEta, fresnel::kK, kScale};
}

template <class Model, class Fresnel>
struct Lobe {
  template <class S>
  using Shape = typename Model::template Shape<S>;

  template <class S>
  struct Channel {
    S scale;
    [[no_unique_address]] typename Fresnel::template Channel<S> fresnel;
  };

  template <class N>
  struct Stage {
    HalfVector<N> half;
    typename Model::template Stage<N> model;
  };

  template <class N>
  struct Refined {
    typename Model::template Refined<N> model;
    [[no_unique_address]] typename Fresnel::template Refined<N> fresnel;
  };

  template <class N>
  struct Terms {
    typename N::Real amplitude;
    [[no_unique_address]] typename Fresnel::template Terms<N> fresnel;
  };

  template <class S>
  static Shape<S> shape(const ParameterValues<S>& p) {
    return Model::shape(p);
  }

  template <class S>
  static Channel<S> channel(const ParameterValues<S>& p, int c) {
    return {p.colour("scale", c), Fresnel::channel(p, c)};
  }

  template <class N>
  static GONIO_INLINE Stage<N> stage(const Shape<typename N::WideScalar>& shape,
                                     const Geometry<N>& g) {
    return {g.half, Model::template stage<N>(shape, g)};
  }

  template <class N>
  static GONIO_INLINE Refined<N> refine(const Shape<typename N::WideScalar>& shape,
                                        const Stage<N>& stage) {
    return {Model::template refine<N>(shape, stage.half, stage.model),
            Fresnel::template refine<N>(stage.half)};
  }

  template <class N>
  static GONIO_INLINE Terms<N> terms(const Shape<typename N::WideScalar>& shape,
                                     const Stage<N>& stage, const Refined<N>& refined) {
    return {min(N::largest(), Model::template amplitude<N>(shape, stage.model, refined.model)),
            Fresnel::template terms<N>(refined.fresnel)};
  }

  // Sampling: a Model that can draw its own lobe has sample(shape, wi, xi), the Aim<N> that its
  // density needs of a pair beside the steps above, aim(shape, geometry), and
  // pdf(shape, half, stage, refined, aim). All colours share it.
  using Drawn = Model;
  template <class N>
  using Aim = typename Model::template Aim<N>;

  template <class N>
  static GONIO_INLINE Aim<N> aim(const Shape<typename N::WideScalar>& shape, const Geometry<N>& g) {
    return Model::template aim<N>(shape, g);
  }

  template <class N>
  static GONIO_INLINE typename N::Real pdf(const Shape<typename N::WideScalar>& shape,
                                           const Stage<N>& stage, const Refined<N>& refined,
                                           const Aim<N>& aim) {
    return Model::template pdf<N>(shape, stage.half, stage.model, refined.model, aim);
  }

  template <class N>
  static GONIO_INLINE typename N::Real eval(const Terms<N>& t,
                                            const Channel<typename N::WideScalar>& wide,
                                            const Channel<typename N::RealScalar>& real) {
    using Real = typename N::Real;
    return t.amplitude * (Real(real.scale) *
                          Fresnel::template reflectance<N>(t.fresnel, wide.fresnel, real.fresnel));
  }
};

// The kinds of a microfacet model, in the order of fresnel::kWords.
template <class Model>
using FresnelKinds = TypeList<Lobe<Model, fresnel::None>, Lobe<Model, fresnel::Schlick>,
                              Lobe<Model, fresnel::Dielectric>, Lobe<Model, fresnel::Conductor>>;

}  // namespace gonio
