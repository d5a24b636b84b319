// Two packets of float32 that are computed with as one. Where a formula is a long chain of
// dependent steps, the processor works on one packet while it waits for the other.
#pragma once

#include "numeric/number.h"
#include "numeric/warp.h"

namespace gonio::GONIO_ISA {

struct TwoMasks {
  Mask a, b;
  friend GONIO_INLINE TwoMasks operator&(TwoMasks x, TwoMasks y) { return {x.a & y.a, x.b & y.b}; }
  [[nodiscard]] GONIO_INLINE bool all() const { return a.all() && b.all(); }
};

struct TwoFloats {
  Float a, b;
  TwoFloats() = default;
  GONIO_INLINE TwoFloats(Float x, Float y) : a(x), b(y) {}
  // NOLINTNEXTLINE(google-explicit-constructor)
  GONIO_INLINE TwoFloats(double x) : a(x), b(a) {}

  static GONIO_INLINE TwoFloats load(const float* p) {
    return {Float::load(p), Float::load(p + raw::kWidth)};
  }
  GONIO_INLINE void store(float* p) const { a.store(p), b.store(p + raw::kWidth); }

  friend GONIO_INLINE TwoFloats operator+(TwoFloats x, TwoFloats y) {
    return {x.a + y.a, x.b + y.b};
  }
  friend GONIO_INLINE TwoFloats operator-(TwoFloats x, TwoFloats y) {
    return {x.a - y.a, x.b - y.b};
  }
  friend GONIO_INLINE TwoFloats operator*(TwoFloats x, TwoFloats y) {
    return {x.a * y.a, x.b * y.b};
  }
  friend GONIO_INLINE TwoFloats operator/(TwoFloats x, TwoFloats y) {
    return {x.a / y.a, x.b / y.b};
  }
  friend GONIO_INLINE TwoFloats operator-(TwoFloats x) { return {-x.a, -x.b}; }
  friend GONIO_INLINE TwoMasks operator<(TwoFloats x, TwoFloats y) {
    return {x.a < y.a, x.b < y.b};
  }
  friend GONIO_INLINE TwoFloats min(TwoFloats x, TwoFloats y) {
    return {min(x.a, y.a), min(x.b, y.b)};
  }
  friend GONIO_INLINE TwoFloats max(TwoFloats x, TwoFloats y) {
    return {max(x.a, y.a), max(x.b, y.b)};
  }
  friend GONIO_INLINE TwoFloats multiply_add(TwoFloats x, TwoFloats y, TwoFloats z) {
    return {multiply_add(x.a, y.a, z.a), multiply_add(x.b, y.b, z.b)};
  }
  friend GONIO_INLINE TwoFloats sum_of_products(TwoFloats x, TwoFloats y, TwoFloats z,
                                                TwoFloats w) {
    return {sum_of_products(x.a, y.a, z.a, w.a), sum_of_products(x.b, y.b, z.b, w.b)};
  }
  friend GONIO_INLINE TwoFloats absolute(TwoFloats x) { return {absolute(x.a), absolute(x.b)}; }
  friend GONIO_INLINE TwoFloats sqrt(TwoFloats x) { return {sqrt(x.a), sqrt(x.b)}; }
  friend GONIO_INLINE TwoFloats select(TwoMasks m, TwoFloats x, TwoFloats y) {
    return {select(m.a, x.a, y.a), select(m.b, x.b, y.b)};
  }
};

GONIO_INLINE TwoFloats log2_of_rest(TwoFloats x, TwoFloats rest) {
  return {log2_of_rest(x.a, rest.a), log2_of_rest(x.b, rest.b)};
}
GONIO_INLINE Exp2<TwoFloats> exp2_of(TwoFloats x) {
  const Exp2<Float> a = exp2_of(x.a), b = exp2_of(x.b);
  return {{a.power, b.power}, {a.one_minus, b.one_minus}};
}
template <>
GONIO_INLINE Turn<TwoFloats> half_turn(TwoFloats x) {
  const Turn<Float> a = half_turn(x.a), b = half_turn(x.b);
  return {{a.cos, b.cos}, {a.sin, b.sin}};
}

// Fast's numbers, two packets at a time.
struct TwofoldFast : Fast {
  using Real = TwoFloats;
  using Mask = TwoMasks;
  static GONIO_INLINE Real inverse_length(Real e) {
    return {Fast::inverse_length(e.a), Fast::inverse_length(e.b)};
  }
};

}  // namespace gonio::GONIO_ISA
