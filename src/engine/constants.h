// A prepared lobe: what a kernel reads. Plain data, laid out alike for every instruction set.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "gonio/engine/material.h"
#include "numeric/inline.h"

namespace gonio {

// S is double, or Dual<double> for derivatives.
template <class Kind, class S = double>
struct Constants {
  static constexpr bool kForFloat = std::is_same_v<S, double>;
  typename Kind::template Shape<S> shape;
  int channels;
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

struct MeasuredConstants {
  const float* table;  // MeasuredTable::data()
  // A bit a cell: whether a lookup from it meets a hole (HoleMap); null if none does.
  const std::uint64_t* holes = nullptr;
};

}  // namespace gonio
