// Raw vector operations, AVX-512 (F, DQ, VL, BW): 16 floats in one register, 16 doubles in two.
// The same names stand in isa_avx2.h and isa_baseline.h; packet.h builds the number types on them.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "numeric/inline.h"

namespace gonio::avx512::raw {

inline constexpr int kWidth = 16;  // lanes of a packet
using F = __m512;                  // kWidth floats
using D = __m512d;                 // kWidth / 2 doubles
using M = __mmask16;               // one bit a lane

GONIO_INLINE F broadcast(float x) { return _mm512_set1_ps(x); }
GONIO_INLINE D broadcast(double x) { return _mm512_set1_pd(x); }
GONIO_INLINE F load(const float* p) { return _mm512_loadu_ps(p); }
GONIO_INLINE D load(const double* p) { return _mm512_loadu_pd(p); }
GONIO_INLINE void store(float* p, F x) { _mm512_storeu_ps(p, x); }
GONIO_INLINE void store(double* p, D x) { _mm512_storeu_pd(p, x); }

GONIO_INLINE F min(F a, F b) { return _mm512_min_ps(a, b); }
GONIO_INLINE D min(D a, D b) { return _mm512_min_pd(a, b); }
GONIO_INLINE F max(F a, F b) { return _mm512_max_ps(a, b); }
GONIO_INLINE D max(D a, D b) { return _mm512_max_pd(a, b); }
GONIO_INLINE F multiply_add(F a, F b, F c) { return _mm512_fmadd_ps(a, b, c); }
GONIO_INLINE D multiply_add(D a, D b, D c) { return _mm512_fmadd_pd(a, b, c); }
// The rounded product a b and its rounding error. The barrier keeps the compiler from fusing the
// product into a sum that needs it rounded.
GONIO_INLINE void exact_product(D a, D b, D& product, D& error) {
  product = a * b;
  asm("" : "+v"(product));
  error = _mm512_fmsub_pd(a, b, product);
}
GONIO_INLINE F absolute(F x) { return _mm512_abs_ps(x); }
GONIO_INLINE F sqrt(F x) { return _mm512_sqrt_ps(x); }
GONIO_INLINE D sqrt(D x) { return _mm512_sqrt_pd(x); }
GONIO_INLINE D round(D x) {
  return _mm512_roundscale_pd(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
GONIO_INLINE F round(F x) {
  return _mm512_roundscale_ps(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
GONIO_INLINE D floor(D x) {
  return _mm512_roundscale_pd(x, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}

// a/b to 42 bits, for normal b: an estimate of 1/b to 14 bits and one third-order step.
GONIO_INLINE D divide_fast(D a, D b) {
  const D r = _mm512_rcp14_pd(b);
  const D e = _mm512_fnmadd_pd(b, r, _mm512_set1_pd(1));
  return a * _mm512_fmadd_pd(r, _mm512_fmadd_pd(e, e, e), r);
}

// floor(log2 x) for normal x > 0, and x * 2^k for whole k.
GONIO_INLINE D exponent(D x) { return _mm512_getexp_pd(x); }
GONIO_INLINE F exponent(F x) { return _mm512_getexp_ps(x); }
GONIO_INLINE D scale(D x, D k) { return _mm512_scalef_pd(x, k); }
GONIO_INLINE F scale(F x, F k) { return _mm512_scalef_ps(x, k); }

// The nearest whole k to log2(a / c), give or take .09, as 2^k and as k; 0 whenever a/c lies in
// [1, 4/3). The bits of a positive number grow like its logarithm, from corner to corner.
GONIO_INLINE void nearest_power(D a, D c, D& power, D& k) {
  const __m512i difference = _mm512_sub_epi64(_mm512_castpd_si512(a), _mm512_castpd_si512(c));
  const __m512i biased = _mm512_add_epi64(difference, _mm512_set1_epi64(0x3ff8000000000000));
  power = _mm512_castsi512_pd(_mm512_and_si512(biased, _mm512_set1_epi64(0x7ff0000000000000)));
  k = exponent(power);
}
// x = k + (m - 1), k whole and m in [1, 2), for x in [-255, 0], to 2^-24; smaller x as -255. The
// sum with a constant whose last bit is worth 2^-23 leaves both in the low half of the bits.
GONIO_INLINE void split_exponent(D lo, D hi, F& k, F& m) {
  const D magic = _mm512_set1_pd(0x1.8p29), least = _mm512_set1_pd(0x1.8p29 - 255);
  const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
  const __m512i fixed = _mm512_permutex2var_epi32(_mm512_castpd_si512(max(lo + magic, least)), even,
                                                  _mm512_castpd_si512(max(hi + magic, least)));
  k = _mm512_cvtepi32_ps(_mm512_srai_epi32(fixed, 23));
  const __m512i fraction = _mm512_and_si512(fixed, _mm512_set1_epi32(0x007fffff));
  m = _mm512_castsi512_ps(_mm512_or_si512(fraction, _mm512_set1_epi32(0x3f800000)));
}

GONIO_INLINE void widen(F x, D& lo, D& hi) {
  lo = _mm512_cvtps_pd(_mm512_castps512_ps256(x));
  hi = _mm512_cvtps_pd(_mm512_extractf32x8_ps(x, 1));
}
// The kWidth floats at p as doubles. Converting from memory spares the shuffles that widen() needs.
GONIO_INLINE void load_widened(const float* p, D& lo, D& hi) {
  lo = _mm512_cvtps_pd(_mm256_loadu_ps(p));
  hi = _mm512_cvtps_pd(_mm256_loadu_ps(p + 8));
}
GONIO_INLINE F narrow(D lo, D hi) {
  return _mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(lo)), _mm512_cvtpd_ps(hi), 1);
}

GONIO_INLINE M less(F a, F b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
GONIO_INLINE M less(D alo, D ahi, D blo, D bhi) {
  return _mm512_kunpackb(_mm512_cmp_pd_mask(ahi, bhi, _CMP_LT_OQ),
                         _mm512_cmp_pd_mask(alo, blo, _CMP_LT_OQ));
}
GONIO_INLINE M mask_and(M a, M b) { return _kand_mask16(a, b); }
GONIO_INLINE unsigned bits(M m) { return _cvtmask16_u32(m); }

// A byte a lane: `value` where the lane's bit is set, else 0.
GONIO_INLINE void store_bytes(std::uint8_t* to, unsigned bits, std::uint8_t value) {
  const __m128i bytes = _mm_maskz_set1_epi8(static_cast<__mmask16>(bits), static_cast<char>(value));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), bytes);
}

GONIO_INLINE F select(M m, F a, F b) { return _mm512_mask_blend_ps(m, b, a); }
GONIO_INLINE void select(M m, D& lo, D& hi, D blo, D bhi) {
  lo = _mm512_mask_blend_pd(static_cast<__mmask8>(m), blo, lo);
  hi = _mm512_mask_blend_pd(static_cast<__mmask8>(m >> 8), bhi, hi);
}

// table[index], lane by lane; the index is a whole number held as a double.
GONIO_INLINE F gather(const float* table, D lo, D hi) {
  const __m256i a = _mm512_cvttpd_epi32(lo);
  const __m256i b = _mm512_cvttpd_epi32(hi);
  return _mm512_i32gather_ps(_mm512_inserti64x4(_mm512_castsi256_si512(a), b, 1), table, 4);
}

// One of the 16 numbers at `table`, lane by lane; the index is a whole number held as a float.
GONIO_INLINE F pick16(const float* table, F index) {
  return _mm512_permutexvar_ps(_mm512_cvttps_epi32(index), load(table));
}

// The products of the lower 32 bits of 64-bit lanes.
using I = __m512i;
GONIO_INLINE I multiply_low(I a, I b) { return _mm512_mul_epu32(a, b); }
GONIO_INLINE I broadcast(long long x) { return _mm512_set1_epi64(x); }
GONIO_INLINE I load(const long long* p) { return _mm512_loadu_si512(p); }
GONIO_INLINE void store(long long* p, I x) { _mm512_storeu_si512(p, x); }
GONIO_INLINE I high_half(I x) { return _mm512_srli_epi64(x, 32); }

// Between kWidth triples xyz xyz ... and their components.
GONIO_INLINE void split3(const float* from, F& x, F& y, F& z) {
  const F a = load(from), b = load(from + 16), c = load(from + 32);
  // Of a and b together, then of that and c.
  const auto pick = [&](__m512i ab, __m512i abc) {
    return _mm512_permutex2var_ps(_mm512_permutex2var_ps(a, ab, b), abc, c);
  };
  x = pick(_mm512_setr_epi32(0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30, 0, 0, 0, 0, 0),
           _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 17, 20, 23, 26, 29));
  y = pick(_mm512_setr_epi32(1, 4, 7, 10, 13, 16, 19, 22, 25, 28, 31, 0, 0, 0, 0, 0),
           _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 18, 21, 24, 27, 30));
  z = pick(_mm512_setr_epi32(2, 5, 8, 11, 14, 17, 20, 23, 26, 29, 0, 0, 0, 0, 0, 0),
           _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 16, 19, 22, 25, 28, 31));
}
GONIO_INLINE void join3(F x, F y, F z, float* to) {
  // Of x and y together, then of that and z.
  const auto put = [&](float* at, __m512i xy, __m512i xyz) {
    store(at, _mm512_permutex2var_ps(_mm512_permutex2var_ps(x, xy, y), xyz, z));
  };
  put(to, _mm512_setr_epi32(0, 16, 0, 1, 17, 0, 2, 18, 0, 3, 19, 0, 4, 20, 0, 5),
      _mm512_setr_epi32(0, 1, 16, 3, 4, 17, 6, 7, 18, 9, 10, 19, 12, 13, 20, 15));
  put(to + 16, _mm512_setr_epi32(21, 0, 6, 22, 0, 7, 23, 0, 8, 24, 0, 9, 25, 0, 10, 26),
      _mm512_setr_epi32(0, 21, 2, 3, 22, 5, 6, 23, 8, 9, 24, 11, 12, 25, 14, 15));
  put(to + 32, _mm512_setr_epi32(0, 11, 27, 0, 12, 28, 0, 13, 29, 0, 14, 30, 0, 15, 31, 0),
      _mm512_setr_epi32(26, 1, 2, 27, 4, 5, 28, 7, 8, 29, 10, 11, 30, 13, 14, 31));
}

}  // namespace gonio::avx512::raw
