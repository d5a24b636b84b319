// How far a lobe reaches before it meets the horizon, so that no sample is lost below it.
//
// A half-vector at colatitude theta and azimuth phi reflects wi to above the horizon as long as
// theta < 45 degrees + beta/2, tan(beta) = tan(theta_i) cos(phi - phi_i): far on the side of the
// light, little on the other. A lobe that is the same at phi and phi + 180 degrees is drawn so: an
// axis of two opposite azimuths as if there were no horizon, then a place on the way from the
// horizon over the lobe's centre to the horizon on the other side, by the masses of both. That is a
// continuous map of two numbers: evenly spread numbers give evenly spread directions.
#pragma once

#include <cmath>

#include "numeric/inline.h"
#include "numeric/vec.h"
#include "parts/geometry.h"

namespace gonio {

// xi of one sample, each in [0, 1): which of two lobes or normals, and the direction.
template <class T>
struct Xi {
  T choice, u, v;
};

template <class T>
struct Colatitude {
  T sin2, cos2;
};

// 1 - 2^-x is 1 for larger x, as rounded.
template <class N>
inline constexpr double kNarrow = N::kQuick ? 26 : 55;

template <class T>
GONIO_INLINE T absolute(const T& x) {
  return max(x, -x);
}

// The largest colatitude on the light's side; with sine and cosine exchanged, that on the other.
// `toward` is sin(theta_i) cos(phi - phi_i) and z2 the square of cos(theta_i), up to a common
// factor and its square.
template <class T>
GONIO_INLINE Colatitude<T> reach(const T& toward, const T& z2) {
  using std::sqrt;
  const T a = absolute(toward), r = sqrt(a * a + z2), sum = r + a;
  const T inverse = T(0.5) / max(r * sum, T(1e-37));
  return {sum * sum * inverse, z2 * inverse};
}

// A unit vector in the surface.
template <class T>
struct Tangent {
  T x, y;
};

template <class T>
GONIO_INLINE Tangent<T> unit_tangent(const T& x, const T& y) {
  using std::sqrt;
  const T inverse = T(1) / sqrt(sum_of_products(x, x, y, y));
  return {x * inverse, y * inverse};
}

// The direction that a half-vector reflects k to: the one at this colatitude towards `axis` or, for
// side = -1, away from it. `toward` is k's component along the axis.
template <class T>
GONIO_INLINE Vec3<T> reflected(const Vec3<T>& k, const Tangent<T>& axis, const T& toward,
                               const Colatitude<T>& h, const T& side) {
  using std::sqrt;
  const T slant = side * sqrt(h.sin2 * h.cos2);
  const T twice = T(2) * sum_of_products(toward, h.sin2, k.z, slant);
  return {twice * axis.x - k.x, twice * axis.y - k.y,
          sum_of_products(T(2) * toward, slant, k.z, h.cos2 - h.sin2)};
}

// Profiles of lobes: the mass within a colatitude, and the colatitude within which there is a given
// part of the mass. `mass_beyond_45` is for colatitudes of more than 45 degrees, where a narrow
// lobe has all its mass within, to the last digit. A power of the cosine, the mass beyond theta
// being cos(theta)^(2 half_width):
template <class N>
struct PowerProfile {
  using Real = typename N::Real;
  Real half_width, inverse;
  explicit GONIO_INLINE PowerProfile(double width) : half_width(width), inverse(1 / width) {}
  explicit GONIO_INLINE PowerProfile(const Real& width)
      : half_width(width), inverse(Real(1) / width) {}
  GONIO_INLINE PowerProfile(const Real& width, const Real& one_over)
      : half_width(width), inverse(one_over) {}

  [[nodiscard]] GONIO_INLINE Real mass(const Colatitude<Real>& c) const {
    return exp2_of(half_width * log2_of_rest(c.sin2, c.cos2)).one_minus;
  }
  [[nodiscard]] GONIO_INLINE Real mass_beyond_45(const Colatitude<Real>& c) const {
    return (Real(kNarrow<N>) < half_width).all() ? Real(1) : mass(c);
  }
  [[nodiscard]] GONIO_INLINE Colatitude<Real> at(const Real& part) const {
    const auto cos2 = exp2_of(log2_one_minus(part) * inverse);
    return {cos2.one_minus, cos2.power};
  }
};
// A Gaussian of the slope, the mass beyond theta being 2^(rate tan(theta)^2), rate < 0:
template <class N>
struct SlopeProfile {
  using Real = typename N::Real;
  Real rate;
  [[nodiscard]] GONIO_INLINE Real mass(const Colatitude<Real>& c) const {
    return exp2_of(rate * c.sin2 / max(c.cos2, Real(1e-18))).one_minus;
  }
  [[nodiscard]] GONIO_INLINE Real mass_beyond_45(const Colatitude<Real>& c) const {
    return (rate < Real(-kNarrow<N>)).all() ? Real(1) : mass(c);
  }
  [[nodiscard]] GONIO_INLINE Colatitude<Real> at(const Real& part) const {
    const Real tan2 = log2_one_minus(part) / rate, cos2 = Real(1) / (Real(1) + tan2);
    return {tan2 * cos2, cos2};
  }
};

// A place on the way along an axis whose sides have the masses `plus` and `minus`.
template <class T>
struct Along {
  T mass, sign;  // from the centre; of the side
};
template <class T>
GONIO_INLINE Along<T> along(const T& v, const T& plus, const T& minus) {
  const T way = v * (plus + minus) - plus;
  const auto on_plus = way < T(0);
  // Short of the horizon, where rounding could go below it.
  return {min(absolute(way), select(on_plus, plus, minus) * T(1 - 2.5e-7)),
          select(on_plus, T(1), T(-1))};
}

// What a model derives from whose pdf needs of a pair an aim of the geometry alone.
template <template <class> class TheAim>
struct AimedBy {
  template <class N>
  using Aim = TheAim<N>;

  template <class N>
  static GONIO_INLINE Aim<N> aim(const auto& /*shape*/, const Geometry<N>& g) {
    return Aim<N>(g);
  }
};

}  // namespace gonio
