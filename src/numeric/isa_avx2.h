// Raw vector operations, AVX2 with FMA: 8 floats in one register, 8 doubles in two.
// The same names stand in isa_avx512.h and isa_baseline.h; packet.h builds the number types on
// them.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "numeric/inline.h"

namespace gonio::avx2::raw {

inline constexpr int kWidth = 8;  // lanes of a packet
using F = __m256;                 // kWidth floats
using D = __m256d;                // kWidth / 2 doubles
using M = __m256;                 // all bits of a float lane

GONIO_INLINE F broadcast(float x) { return _mm256_set1_ps(x); }
GONIO_INLINE D broadcast(double x) { return _mm256_set1_pd(x); }
GONIO_INLINE F load(const float* p) { return _mm256_loadu_ps(p); }
GONIO_INLINE D load(const double* p) { return _mm256_loadu_pd(p); }
GONIO_INLINE void store(float* p, F x) { _mm256_storeu_ps(p, x); }
GONIO_INLINE void store(double* p, D x) { _mm256_storeu_pd(p, x); }

GONIO_INLINE F min(F a, F b) { return _mm256_min_ps(a, b); }
GONIO_INLINE D min(D a, D b) { return _mm256_min_pd(a, b); }
GONIO_INLINE F max(F a, F b) { return _mm256_max_ps(a, b); }
GONIO_INLINE D max(D a, D b) { return _mm256_max_pd(a, b); }
GONIO_INLINE F multiply_add(F a, F b, F c) { return _mm256_fmadd_ps(a, b, c); }
GONIO_INLINE D multiply_add(D a, D b, D c) { return _mm256_fmadd_pd(a, b, c); }
// The rounded product a b and its rounding error. The barrier keeps the compiler from fusing the
// product into a sum that needs it rounded.
GONIO_INLINE void exact_product(D a, D b, D& product, D& error) {
  product = a * b;
  asm("" : "+x"(product));
  error = _mm256_fmsub_pd(a, b, product);
}
GONIO_INLINE F absolute(F x) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0F), x); }
GONIO_INLINE F sqrt(F x) { return _mm256_sqrt_ps(x); }
GONIO_INLINE D sqrt(D x) { return _mm256_sqrt_pd(x); }
GONIO_INLINE D round(D x) {
  return _mm256_round_pd(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
GONIO_INLINE F round(F x) {
  return _mm256_round_ps(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
GONIO_INLINE D floor(D x) { return _mm256_floor_pd(x); }

// AVX2 has no estimate in double; a division is exact and fast enough.
GONIO_INLINE D divide_fast(D a, D b) { return a / b; }

// floor(log2 x) for normal x > 0: the exponent bits, made a double by a constant whose last bit is
// worth one.
GONIO_INLINE D exponent(D x) {
  const __m256i biased = _mm256_srli_epi64(_mm256_castpd_si256(x), 52);
  const __m256i magic = _mm256_set1_epi64x(0x4330000000000000);  // 2^52
  return _mm256_castsi256_pd(_mm256_or_si256(biased, magic)) - _mm256_set1_pd(0x1p52 + 1023);
}
GONIO_INLINE F exponent(F x) {
  const __m256i biased = _mm256_srli_epi32(_mm256_castps_si256(x), 23);
  return _mm256_cvtepi32_ps(_mm256_sub_epi32(biased, _mm256_set1_epi32(127)));
}
// x * 2^k for whole k with a normal result.
GONIO_INLINE D scale(D x, D k) {
  const __m256i bits = _mm256_castpd_si256(k + _mm256_set1_pd(0x1.8p52));
  return _mm256_castsi256_pd(_mm256_add_epi64(_mm256_castpd_si256(x), _mm256_slli_epi64(bits, 52)));
}
// x * 2^k for whole k in [-126, 127].
GONIO_INLINE F scale_once(F x, F k) {
  const __m256i biased = _mm256_add_epi32(_mm256_cvtps_epi32(k), _mm256_set1_epi32(127));
  return x * _mm256_castsi256_ps(_mm256_slli_epi32(biased, 23));
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
  const __m256i difference = _mm256_sub_epi64(_mm256_castpd_si256(a), _mm256_castpd_si256(c));
  const __m256i biased = _mm256_add_epi64(difference, _mm256_set1_epi64x(0x3ff8000000000000));
  power = _mm256_castsi256_pd(_mm256_and_si256(biased, _mm256_set1_epi64x(0x7ff0000000000000)));
  k = exponent(power);
}
// x = k + (m - 1), k whole and m in [1, 2), for x in [-255, 0], to 2^-24; smaller x as -255. The
// sum with a constant whose last bit is worth 2^-23 leaves both in the low half of the bits.
GONIO_INLINE void split_exponent(D lo, D hi, F& k, F& m) {
  const D magic = _mm256_set1_pd(0x1.8p29), least = _mm256_set1_pd(0x1.8p29 - 255);
  const F halves = _mm256_shuffle_ps(_mm256_castpd_ps(max(lo + magic, least)),
                                     _mm256_castpd_ps(max(hi + magic, least)), 0x88);
  const __m256i fixed = _mm256_permute4x64_epi64(_mm256_castps_si256(halves), 0xd8);
  k = _mm256_cvtepi32_ps(_mm256_srai_epi32(fixed, 23));
  const __m256i fraction = _mm256_and_si256(fixed, _mm256_set1_epi32(0x007fffff));
  m = _mm256_castsi256_ps(_mm256_or_si256(fraction, _mm256_set1_epi32(0x3f800000)));
}

GONIO_INLINE void widen(F x, D& lo, D& hi) {
  lo = _mm256_cvtps_pd(_mm256_castps256_ps128(x));
  hi = _mm256_cvtps_pd(_mm256_extractf128_ps(x, 1));
}
// The kWidth floats at p as doubles. Converting from memory spares the shuffles that widen() needs.
GONIO_INLINE void load_widened(const float* p, D& lo, D& hi) {
  lo = _mm256_cvtps_pd(_mm_loadu_ps(p));
  hi = _mm256_cvtps_pd(_mm_loadu_ps(p + 4));
}
GONIO_INLINE F narrow(D lo, D hi) {
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm256_cvtpd_ps(lo)), _mm256_cvtpd_ps(hi), 1);
}

GONIO_INLINE M less(F a, F b) { return _mm256_cmp_ps(a, b, _CMP_LT_OQ); }
GONIO_INLINE __m128 mask_half(D m) {  // four 64-bit masks to four 32-bit ones
  const __m256 f = _mm256_castpd_ps(m);
  return _mm_shuffle_ps(_mm256_castps256_ps128(f), _mm256_extractf128_ps(f, 1), 0x88);
}
GONIO_INLINE M less(D alo, D ahi, D blo, D bhi) {
  const __m128 lo = mask_half(_mm256_cmp_pd(alo, blo, _CMP_LT_OQ));
  const __m128 hi = mask_half(_mm256_cmp_pd(ahi, bhi, _CMP_LT_OQ));
  return _mm256_insertf128_ps(_mm256_castps128_ps256(lo), hi, 1);
}
GONIO_INLINE M mask_and(M a, M b) { return _mm256_and_ps(a, b); }
GONIO_INLINE unsigned bits(M m) { return static_cast<unsigned>(_mm256_movemask_ps(m)); }

// A byte a lane: `value` where the lane's bit is set, else 0.
GONIO_INLINE void store_bytes(std::uint8_t* to, unsigned bits, std::uint8_t value) {
  for (int i = 0; i < kWidth; ++i)
    to[i] = static_cast<std::uint8_t>((0U - (bits >> i & 1U)) & value);
}

GONIO_INLINE F select(M m, F a, F b) { return _mm256_blendv_ps(b, a, m); }
GONIO_INLINE void select(M m, D& lo, D& hi, D blo, D bhi) {
  const __m256i wide_lo = _mm256_cvtepi32_epi64(_mm_castps_si128(_mm256_castps256_ps128(m)));
  const __m256i wide_hi = _mm256_cvtepi32_epi64(_mm_castps_si128(_mm256_extractf128_ps(m, 1)));
  lo = _mm256_blendv_pd(blo, lo, _mm256_castsi256_pd(wide_lo));
  hi = _mm256_blendv_pd(bhi, hi, _mm256_castsi256_pd(wide_hi));
}

// table[index], lane by lane; the index is a whole number held as a double.
GONIO_INLINE F gather(const float* table, D lo, D hi) {
  const __m128i a = _mm256_cvttpd_epi32(lo);
  const __m128i b = _mm256_cvttpd_epi32(hi);
  return _mm256_i32gather_ps(table, _mm256_inserti128_si256(_mm256_castsi128_si256(a), b, 1), 4);
}

// One of the 16 numbers at `table`, lane by lane; the index is a whole number held as a float.
GONIO_INLINE F pick16(const float* table, F index) {
  const __m256i at = _mm256_cvttps_epi32(index);
  const F low = _mm256_permutevar8x32_ps(load(table), at);
  const F high = _mm256_permutevar8x32_ps(load(table + 8), at);
  return _mm256_blendv_ps(low, high, _mm256_castsi256_ps(_mm256_slli_epi32(at, 28)));
}

// The products of the lower 32 bits of 64-bit lanes.
using I = __m256i;
GONIO_INLINE I multiply_low(I a, I b) { return _mm256_mul_epu32(a, b); }
GONIO_INLINE I broadcast(long long x) { return _mm256_set1_epi64x(x); }
GONIO_INLINE I load(const long long* p) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p));
}
GONIO_INLINE void store(long long* p, I x) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), x);
}
GONIO_INLINE I high_half(I x) { return _mm256_srli_epi64(x, 32); }

// Between kWidth triples xyz xyz ... and their components. The compiler's shuffles are good enough.
GONIO_INLINE void split3(const float* from, F& x, F& y, F& z) {
  for (int i = 0; i < kWidth; ++i)
    x[i] = from[3 * i], y[i] = from[3 * i + 1], z[i] = from[3 * i + 2];
}
GONIO_INLINE void join3(F x, F y, F z, float* to) {
  for (int i = 0; i < kWidth; ++i) to[3 * i] = x[i], to[3 * i + 1] = y[i], to[3 * i + 2] = z[i];
}

}  // namespace gonio::avx2::raw
