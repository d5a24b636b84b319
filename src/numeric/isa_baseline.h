// Raw vector operations, what every x86-64 has (SSE2): 4 floats in one register, 4 doubles in two.
// The same names stand in isa_avx512.h and isa_avx2.h; packet.h builds the number types on them.
#pragma once

#include <emmintrin.h>

#include <cstdint>

#include "numeric/inline.h"

namespace gonio::baseline::raw {

inline constexpr int kWidth = 4;  // lanes of a packet
using F = __m128;                 // kWidth floats
using D = __m128d;                // kWidth / 2 doubles
using M = __m128;                 // all bits of a float lane

GONIO_INLINE F broadcast(float x) { return _mm_set1_ps(x); }
GONIO_INLINE D broadcast(double x) { return _mm_set1_pd(x); }
GONIO_INLINE F load(const float* p) { return _mm_loadu_ps(p); }
GONIO_INLINE D load(const double* p) { return _mm_loadu_pd(p); }
GONIO_INLINE void store(float* p, F x) { _mm_storeu_ps(p, x); }
GONIO_INLINE void store(double* p, D x) { _mm_storeu_pd(p, x); }

GONIO_INLINE F min(F a, F b) { return _mm_min_ps(a, b); }
GONIO_INLINE D min(D a, D b) { return _mm_min_pd(a, b); }
GONIO_INLINE F max(F a, F b) { return _mm_max_ps(a, b); }
GONIO_INLINE D max(D a, D b) { return _mm_max_pd(a, b); }
GONIO_INLINE F multiply_add(F a, F b, F c) { return a * b + c; }
GONIO_INLINE D multiply_add(D a, D b, D c) { return a * b + c; }
// The upper 26 bits of x, and the rest (Dekker 1971).
GONIO_INLINE void halve_bits(D x, D& high, D& low) {
  const D scaled = x * _mm_set1_pd(134217729);
  high = scaled - (scaled - x);
  low = x - high;
}
// The rounded product a b and its rounding error.
GONIO_INLINE void exact_product(D a, D b, D& product, D& error) {
  D ah, al, bh, bl;
  halve_bits(a, ah, al);
  halve_bits(b, bh, bl);
  product = a * b;
  error = ((ah * bh - product) + ah * bl + al * bh) + al * bl;
}
GONIO_INLINE F absolute(F x) { return _mm_andnot_ps(_mm_set1_ps(-0.0F), x); }
GONIO_INLINE F sqrt(F x) { return _mm_sqrt_ps(x); }
GONIO_INLINE D sqrt(D x) { return _mm_sqrt_pd(x); }
// Adding and taking away 1.5 * 2^52 leaves the nearest whole number, for |x| < 2^51.
GONIO_INLINE D round(D x) { return (x + _mm_set1_pd(0x1.8p52)) - _mm_set1_pd(0x1.8p52); }
GONIO_INLINE F round(F x) { return _mm_cvtepi32_ps(_mm_cvtps_epi32(x)); }  // for |x| < 2^31
GONIO_INLINE D floor(D x) {
  const D nearest = round(x);
  return nearest - _mm_and_pd(_mm_cmpgt_pd(nearest, x), _mm_set1_pd(1));
}

// SSE2 has no estimate in double; a division is exact and fast enough.
GONIO_INLINE D divide_fast(D a, D b) { return a / b; }

// floor(log2 x) for normal x > 0: the exponent bits, made a double by a constant whose last bit is
// worth one.
GONIO_INLINE D exponent(D x) {
  const __m128i biased = _mm_srli_epi64(_mm_castpd_si128(x), 52);
  const __m128i magic = _mm_set1_epi64x(0x4330000000000000);  // 2^52
  return _mm_castsi128_pd(_mm_or_si128(biased, magic)) - _mm_set1_pd(0x1p52 + 1023);
}
GONIO_INLINE F exponent(F x) {
  const __m128i biased = _mm_srli_epi32(_mm_castps_si128(x), 23);
  return _mm_cvtepi32_ps(_mm_sub_epi32(biased, _mm_set1_epi32(127)));
}
// x * 2^k for whole k with a normal result.
GONIO_INLINE D scale(D x, D k) {
  const __m128i bits = _mm_castpd_si128(k + _mm_set1_pd(0x1.8p52));
  return _mm_castsi128_pd(_mm_add_epi64(_mm_castpd_si128(x), _mm_slli_epi64(bits, 52)));
}
// x * 2^k for whole k in [-126, 127].
GONIO_INLINE F scale_once(F x, F k) {
  const __m128i biased = _mm_add_epi32(_mm_cvtps_epi32(k), _mm_set1_epi32(127));
  return x * _mm_castsi128_ps(_mm_slli_epi32(biased, 23));
}
// x * 2^k for whole k in [-378, 127]: three steps, so that a large x meets a small 2^k without
// underflow.
GONIO_INLINE F scale(F x, F k) {
  const F low = max(k, broadcast(-126.0F));
  const F rest = k - low;
  const F middle = max(rest, broadcast(-126.0F));
  return scale_once(scale_once(scale_once(x, low), middle), rest - middle);
}

// The nearest whole k to log2(a / c), give or take .09, as 2^k and as k; 0 whenever a/c lies in
// [1, 4/3). The bits of a positive number grow like its logarithm, from corner to corner.
GONIO_INLINE void nearest_power(D a, D c, D& power, D& k) {
  const __m128i difference = _mm_sub_epi64(_mm_castpd_si128(a), _mm_castpd_si128(c));
  const __m128i biased = _mm_add_epi64(difference, _mm_set1_epi64x(0x3ff8000000000000));
  power = _mm_castsi128_pd(_mm_and_si128(biased, _mm_set1_epi64x(0x7ff0000000000000)));
  k = exponent(power);
}
// x = k + (m - 1), k whole and m in [1, 2), for x in [-255, 0], to 2^-24; smaller x as -255. The
// sum with a constant whose last bit is worth 2^-23 leaves both in the low half of the bits.
GONIO_INLINE void split_exponent(D lo, D hi, F& k, F& m) {
  const D magic = _mm_set1_pd(0x1.8p29), least = _mm_set1_pd(0x1.8p29 - 255);
  const __m128i fixed = _mm_castps_si128(_mm_shuffle_ps(
      _mm_castpd_ps(max(lo + magic, least)), _mm_castpd_ps(max(hi + magic, least)), 0x88));
  k = _mm_cvtepi32_ps(_mm_srai_epi32(fixed, 23));
  const __m128i fraction = _mm_and_si128(fixed, _mm_set1_epi32(0x007fffff));
  m = _mm_castsi128_ps(_mm_or_si128(fraction, _mm_set1_epi32(0x3f800000)));
}

GONIO_INLINE void widen(F x, D& lo, D& hi) {
  lo = _mm_cvtps_pd(x);
  hi = _mm_cvtps_pd(_mm_movehl_ps(x, x));
}
// The kWidth floats at p as doubles.
GONIO_INLINE void load_widened(const float* p, D& lo, D& hi) { widen(load(p), lo, hi); }
GONIO_INLINE F narrow(D lo, D hi) { return _mm_movelh_ps(_mm_cvtpd_ps(lo), _mm_cvtpd_ps(hi)); }

GONIO_INLINE M less(F a, F b) { return _mm_cmplt_ps(a, b); }
GONIO_INLINE M less(D alo, D ahi, D blo, D bhi) {
  return _mm_shuffle_ps(_mm_castpd_ps(_mm_cmplt_pd(alo, blo)),
                        _mm_castpd_ps(_mm_cmplt_pd(ahi, bhi)), 0x88);
}
GONIO_INLINE M mask_and(M a, M b) { return _mm_and_ps(a, b); }
GONIO_INLINE unsigned bits(M m) { return static_cast<unsigned>(_mm_movemask_ps(m)); }

// A byte a lane: `value` where the lane's bit is set, else 0.
GONIO_INLINE void store_bytes(std::uint8_t* to, unsigned bits, std::uint8_t value) {
  for (int i = 0; i < kWidth; ++i)
    to[i] = static_cast<std::uint8_t>((0U - (bits >> i & 1U)) & value);
}

GONIO_INLINE F select(M m, F a, F b) { return _mm_or_ps(_mm_and_ps(m, a), _mm_andnot_ps(m, b)); }
GONIO_INLINE D select_half(D m, D a, D b) {
  return _mm_or_pd(_mm_and_pd(m, a), _mm_andnot_pd(m, b));
}
GONIO_INLINE void select(M m, D& lo, D& hi, D blo, D bhi) {
  lo = select_half(_mm_castps_pd(_mm_unpacklo_ps(m, m)), lo, blo);
  hi = select_half(_mm_castps_pd(_mm_unpackhi_ps(m, m)), hi, bhi);
}

// table[index], lane by lane; the index is a whole number held as a double.
GONIO_INLINE F gather(const float* table, D lo, D hi) {
  return _mm_setr_ps(table[static_cast<int>(lo[0])], table[static_cast<int>(lo[1])],
                     table[static_cast<int>(hi[0])], table[static_cast<int>(hi[1])]);
}

// One of the 16 numbers at `table`, lane by lane; the index is a whole number held as a float.
GONIO_INLINE F pick16(const float* table, F index) {
  return _mm_setr_ps(table[static_cast<int>(index[0])], table[static_cast<int>(index[1])],
                     table[static_cast<int>(index[2])], table[static_cast<int>(index[3])]);
}

// The products of the lower 32 bits of 64-bit lanes.
using I = __m128i;
GONIO_INLINE I multiply_low(I a, I b) { return _mm_mul_epu32(a, b); }
GONIO_INLINE I broadcast(long long x) { return _mm_set1_epi64x(x); }
GONIO_INLINE I load(const long long* p) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
}
GONIO_INLINE void store(long long* p, I x) { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), x); }
GONIO_INLINE I high_half(I x) { return _mm_srli_epi64(x, 32); }

// Between kWidth triples xyz xyz ... and their components. The compiler's shuffles are good enough.
GONIO_INLINE void split3(const float* from, F& x, F& y, F& z) {
  for (int i = 0; i < kWidth; ++i)
    x[i] = from[3 * i], y[i] = from[3 * i + 1], z[i] = from[3 * i + 2];
}
GONIO_INLINE void join3(F x, F y, F z, float* to) {
  for (int i = 0; i < kWidth; ++i) to[3 * i] = x[i], to[3 * i + 1] = y[i], to[3 * i + 2] = z[i];
}

}  // namespace gonio::baseline::raw
