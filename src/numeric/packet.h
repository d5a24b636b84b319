// Packets: as many lanes as the instruction set has floats in a register, as float32 or as float64.
//
// They behave like numbers (+ - * /, comparisons, select instead of ?:), so that a formula is
// written once for packets, scalars and dual numbers. Double<Exactness> comes in two kinds: `exact`
// divides correctly rounded; `quick` divides to 42 bits, and its elementary functions are as good
// as float32 results need (errors.h). Compiled once per instruction set, in the namespace of
// GONIO_ISA.
#pragma once

#include "numeric/inline.h"

#if defined(GONIO_ISA_avx512)
#include "numeric/isa_avx512.h"
#elif defined(GONIO_ISA_avx2)
#include "numeric/isa_avx2.h"
#else
#include "numeric/isa_baseline.h"
#endif

namespace gonio::GONIO_ISA {

struct Mask {
  raw::M m;
  friend GONIO_INLINE Mask operator&(Mask a, Mask b) { return {raw::mask_and(a.m, b.m)}; }
  [[nodiscard]] GONIO_INLINE unsigned bits() const { return raw::bits(m); }  // one bit a lane
  [[nodiscard]] GONIO_INLINE bool all() const;
};

inline constexpr unsigned kAllLanes = (1U << raw::kWidth) - 1;
GONIO_INLINE bool Mask::all() const { return bits() == kAllLanes; }

struct Float {
  raw::F v;
  Float() = default;
  GONIO_INLINE explicit Float(raw::F x) : v(x) {}
  // Implicit: formulas mix in numbers.
  // NOLINTNEXTLINE(google-explicit-constructor)
  GONIO_INLINE Float(double x) : v(raw::broadcast(static_cast<float>(x))) {}

  static GONIO_INLINE Float load(const float* p) { return Float(raw::load(p)); }
  GONIO_INLINE void store(float* p) const { raw::store(p, v); }

  friend GONIO_INLINE Float operator+(Float a, Float b) { return Float(a.v + b.v); }
  friend GONIO_INLINE Float operator-(Float a, Float b) { return Float(a.v - b.v); }
  friend GONIO_INLINE Float operator*(Float a, Float b) { return Float(a.v * b.v); }
  friend GONIO_INLINE Float operator/(Float a, Float b) { return Float(a.v / b.v); }
  friend GONIO_INLINE Float operator-(Float a) { return Float(-a.v); }
  friend GONIO_INLINE Mask operator<(Float a, Float b) { return {raw::less(a.v, b.v)}; }
  friend GONIO_INLINE Float min(Float a, Float b) { return Float(raw::min(a.v, b.v)); }
  friend GONIO_INLINE Float max(Float a, Float b) { return Float(raw::max(a.v, b.v)); }
  // a b + c d. The compiler's own choice of the product to round first would differ between places.
  friend GONIO_INLINE Float sum_of_products(Float a, Float b, Float c, Float d) {
    return Float(raw::multiply_add(a.v, b.v, c.v * d.v));
  }
  // a b + c, rounded once where the instruction set can. If left to the compiler, that depends on
  // whether a b is also used elsewhere.
  friend GONIO_INLINE Float multiply_add(Float a, Float b, Float c) {
    return Float(raw::multiply_add(a.v, b.v, c.v));
  }
  friend GONIO_INLINE Float absolute(Float a) { return Float(raw::absolute(a.v)); }
  friend GONIO_INLINE Float sqrt(Float a) { return Float(raw::sqrt(a.v)); }
  friend GONIO_INLINE Float round(Float a) { return Float(raw::round(a.v)); }
  friend GONIO_INLINE Float exponent(Float a) { return Float(raw::exponent(a.v)); }
  friend GONIO_INLINE Float select(Mask m, Float a, Float b) {
    return Float(raw::select(m.m, a.v, b.v));
  }
  // One of 16 numbers, lane by lane; the index is a whole number.
  friend GONIO_INLINE Float pick16(const float* table, Float index) {
    return Float(raw::pick16(table, index.v));
  }
};

enum class Exactness { quick, exact };

template <Exactness E>
struct Double {
  raw::D lo, hi;
  Double() = default;
  GONIO_INLINE Double(raw::D l, raw::D h) : lo(l), hi(h) {}
  // NOLINTNEXTLINE(google-explicit-constructor)
  GONIO_INLINE Double(double x) : lo(raw::broadcast(x)), hi(lo) {}
  GONIO_INLINE explicit Double(Float x) { raw::widen(x.v, lo, hi); }

  static GONIO_INLINE Double load(const float* p) {
    Double x;
    raw::load_widened(p, x.lo, x.hi);
    return x;
  }
  static GONIO_INLINE Double load(const double* p) {
    return {raw::load(p), raw::load(p + raw::kWidth / 2)};
  }
  GONIO_INLINE void store(double* p) const {
    raw::store(p, lo), raw::store(p + raw::kWidth / 2, hi);
  }

  friend GONIO_INLINE Double operator+(Double a, Double b) { return {a.lo + b.lo, a.hi + b.hi}; }
  friend GONIO_INLINE Double operator-(Double a, Double b) { return {a.lo - b.lo, a.hi - b.hi}; }
  friend GONIO_INLINE Double operator*(Double a, Double b) { return {a.lo * b.lo, a.hi * b.hi}; }
  friend GONIO_INLINE Double operator-(Double a) { return {-a.lo, -a.hi}; }
  friend GONIO_INLINE Double operator/(Double a, Double b) {
    if constexpr (E == Exactness::exact) {
      return {a.lo / b.lo, a.hi / b.hi};
    } else {
      return {raw::divide_fast(a.lo, b.lo), raw::divide_fast(a.hi, b.hi)};
    }
  }
  friend GONIO_INLINE Mask operator<(Double a, Double b) {
    return {raw::less(a.lo, a.hi, b.lo, b.hi)};
  }
  friend GONIO_INLINE Double min(Double a, Double b) {
    return {raw::min(a.lo, b.lo), raw::min(a.hi, b.hi)};
  }
  friend GONIO_INLINE Double max(Double a, Double b) {
    return {raw::max(a.lo, b.lo), raw::max(a.hi, b.hi)};
  }
  // a b + c and a b + c d, as for Float.
  friend GONIO_INLINE Double multiply_add(Double a, Double b, Double c) {
    return {raw::multiply_add(a.lo, b.lo, c.lo), raw::multiply_add(a.hi, b.hi, c.hi)};
  }
  friend GONIO_INLINE Double sum_of_products(Double a, Double b, Double c, Double d) {
    return {raw::multiply_add(a.lo, b.lo, c.lo * d.lo), raw::multiply_add(a.hi, b.hi, c.hi * d.hi)};
  }
  friend GONIO_INLINE void exact_product(Double a, Double b, Double& product, Double& error) {
    raw::exact_product(a.lo, b.lo, product.lo, error.lo);
    raw::exact_product(a.hi, b.hi, product.hi, error.hi);
  }
  friend GONIO_INLINE Double sqrt(Double a) { return {raw::sqrt(a.lo), raw::sqrt(a.hi)}; }
  friend GONIO_INLINE Double round(Double a) { return {raw::round(a.lo), raw::round(a.hi)}; }
  friend GONIO_INLINE Double floor(Double a) { return {raw::floor(a.lo), raw::floor(a.hi)}; }
  friend GONIO_INLINE Double select(Mask m, Double a, Double b) {
    raw::select(m.m, a.lo, a.hi, b.lo, b.hi);
    return a;
  }
  // About log2(a / c) for 0 < c <= a, as a whole number k and as 2^k; see raw.
  friend GONIO_INLINE void nearest_power(Double a, Double c, Double& power, Double& k) {
    raw::nearest_power(a.lo, c.lo, power.lo, k.lo);
    raw::nearest_power(a.hi, c.hi, power.hi, k.hi);
  }
  // x = k + (m - 1) for -255 <= x <= 0; see raw.
  friend GONIO_INLINE void split_exponent(Double x, Float& k, Float& m) {
    raw::split_exponent(x.lo, x.hi, k.v, m.v);
  }
  // x * 2^k for whole k.
  friend GONIO_INLINE Double scale(Double a, Double k) {
    return {raw::scale(a.lo, k.lo), raw::scale(a.hi, k.hi)};
  }
  friend GONIO_INLINE Float narrow(Double a) { return Float(raw::narrow(a.lo, a.hi)); }
  // table[index], lane by lane; the index is a whole number.
  friend GONIO_INLINE Float gather(const float* table, Double i) {
    return Float(raw::gather(table, i.lo, i.hi));
  }
};

GONIO_INLINE Float scale(Float a, Float k) { return Float(raw::scale(a.v, k.v)); }

}  // namespace gonio::GONIO_ISA
