// A 3-vector of any number type: packets, scalars or dual numbers.
#pragma once

#include "numeric/inline.h"

namespace gonio {

template <class T>
struct Vec3 {
  T x, y, z;

  friend GONIO_INLINE Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend GONIO_INLINE Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend GONIO_INLINE Vec3 operator*(const T& s, const Vec3& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  friend GONIO_INLINE T dot(const Vec3& a, const Vec3& b) {
    return sum_of_products(a.x, b.x, a.y, b.y) + a.z * b.z;
  }
  // s a + t b.
  friend GONIO_INLINE Vec3 combine(const T& s, const Vec3& a, const T& t, const Vec3& b) {
    return {sum_of_products(s, a.x, t, b.x), sum_of_products(s, a.y, t, b.y),
            sum_of_products(s, a.z, t, b.z)};
  }
};

}  // namespace gonio
