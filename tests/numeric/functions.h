// The elementary functions of every instruction set, over arrays: tables like the kernels' own.
#pragma once

#include <cstddef>

namespace gonio::testing {

// Arrays hold a multiple of 16 numbers.
struct Functions {
  void (*weighted_log2_quick)(const double* w, const double* s, const double* c, std::size_t n,
                              double* out);
  void (*weighted_log2_exact)(const double* w, const double* s, const double* c, std::size_t n,
                              double* out);
  void (*times_exp2_quick)(const float* amplitude, const double* x, std::size_t n, float* out);
  void (*times_exp2_exact)(const double* amplitude, const double* x, std::size_t n, double* out);
  void (*angle_quick)(const double* y, const double* x, std::size_t n, double* out);
  void (*angle_exact)(const double* y, const double* x, std::size_t n, double* out);
  void (*divide_quick)(const double* a, const double* b, std::size_t n, double* out);
  void (*product)(const double* a, const double* b, std::size_t n, double* out, double* error);
  // Of n vectors, each an array of x, then one of y, then one of z.
  void (*dot_quick)(const double* a, const double* b, std::size_t n, double* out);
  void (*dot_exact)(const double* a, const double* b, std::size_t n, double* out);
  // 1 / sqrt(1 + e).
  void (*inverse_length_32)(const float* e, std::size_t n, float* out);
  void (*inverse_length_64)(const double* e, std::size_t n, double* out);
  // What samples are drawn by (numeric/warp.h).
  void (*log2_one_minus_32)(const float* x, std::size_t n, float* out);
  void (*log2_one_minus_64)(const double* x, std::size_t n, double* out);
  void (*exp2_32)(const float* x, std::size_t n, float* power, float* one_minus);
  void (*exp2_64)(const double* x, std::size_t n, double* power, double* one_minus);
  void (*half_turn_32)(const float* x, std::size_t n, float* cos, float* sin);
  void (*half_turn_64)(const double* x, std::size_t n, double* cos, double* sin);
  void (*turn_32)(const float* x, std::size_t n, float* cos, float* sin);
  void (*turn_64)(const double* x, std::size_t n, double* cos, double* sin);
};

}  // namespace gonio::testing

namespace gonio::baseline {
extern const testing::Functions kFunctions;
}
namespace gonio::avx2 {
extern const testing::Functions kFunctions;
}
namespace gonio::avx512 {
extern const testing::Functions kFunctions;
}
