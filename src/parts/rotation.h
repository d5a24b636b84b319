// A turn about the normal: where a material's tangents u and v are in the frame that directions are
// given in.
//
// Where they are turned by an angle, counter-clockwise seen from above, f_turned(wi, wo) =
// f(into(wi), into(wo)): the model sees both directions turned back.
#pragma once

#include "numeric/inline.h"
#include "numeric/vec.h"

namespace gonio {

template <class S>
struct Rotation {
  S cos = S(1), sin = S(0);
};

// w as seen from the turned frame. Its z is as given, bit for bit.
template <class T, class S>
GONIO_INLINE Vec3<T> into(const Rotation<S>& turn, const Vec3<T>& w) {
  const T cos(turn.cos), sin(turn.sin);
  return {sum_of_products(cos, w.x, sin, w.y), sum_of_products(cos, w.y, -sin, w.x), w.z};
}
// What into() came from.
template <class T, class S>
GONIO_INLINE Vec3<T> out_of(const Rotation<S>& turn, const Vec3<T>& w) {
  const T cos(turn.cos), sin(turn.sin);
  return {sum_of_products(cos, w.x, -sin, w.y), sum_of_products(cos, w.y, sin, w.x), w.z};
}

}  // namespace gonio
