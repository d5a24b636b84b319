// A prepared lobe: what a kernel reads. Plain data, laid out alike for every instruction set.
#pragma once

#include <array>
#include <bit>
#include <type_traits>

#include "gonio/engine/material.h"
#include "numeric/inline.h"
#include "parts/rotation.h"

namespace gonio {

// Whether a kind's values depend on where the tangents are, by its model's description.
template <class Kind>
constexpr bool has_tangents() {
  if constexpr (requires { Kind::Drawn::kDescription; }) {
    return Kind::Drawn::kDescription.has_tangents();
  } else {
    return false;
  }
}

// How the tangents of a material are turned; nothing for a kind that has none.
template <class S>
struct Tangents {
  Rotation<S> rotation;
  bool turned = false;
};
struct NoTangents {};

// S is double, or Dual<double> for derivatives.
template <class Kind, class S = double>
struct Constants {
  static constexpr bool kForFloat = std::is_same_v<S, double>;
  typename Kind::template Shape<S> shape;
  int channels;
  [[no_unique_address]] std::conditional_t<has_tangents<Kind>(), Tangents<S>, NoTangents> tangents;
  typename Kind::template Channel<S> wide[kMaxChannels];
  // The same numbers again: float32 arithmetic takes its constants from memory without a
  // conversion.
  typename Kind::template Channel<float> real[kForFloat ? kMaxChannels : 1];

  template <class Scalar>
  GONIO_INLINE const auto& channel(int c) const {
    if constexpr (std::is_same_v<Scalar, float>) {
      return real[c];
    } else {
      return wide[c];
    }
  }
};

// A struct of doubles as the same struct of floats.
template <template <class> class Struct>
Struct<float> to_float(const Struct<double>& from) {
  constexpr std::size_t kNumbers = sizeof(Struct<double>) / sizeof(double);
  static_assert(std::is_empty_v<Struct<double>> ||
                kNumbers * sizeof(float) == sizeof(Struct<float>));
  if constexpr (std::is_empty_v<Struct<double>>) {
    return {};
  } else {
    const auto wide = std::bit_cast<std::array<double, kNumbers>>(from);
    std::array<float, kNumbers> narrow;
    for (std::size_t i = 0; i < kNumbers; ++i) narrow[i] = static_cast<float>(wide[i]);
    return std::bit_cast<Struct<float>>(narrow);
  }
}

}  // namespace gonio
