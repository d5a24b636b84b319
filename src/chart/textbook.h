// Textbook sampling of the printed models: for microfacets a half-vector from the distribution of
// normals, for the others one half cosine, one half lobe. Scalar, in the caller's type. The
// samplers are compared with it. xi: one number chooses the strategy, two the direction.
#pragma once

#include "chart/printed.h"

namespace gonio::chart {

template <class T>
using Vector = std::array<T, 3>;

template <class T>
Vector<T> polar(T cos, T phi) {
  const T sine = std::sqrt(std::max(T(0), 1 - cos * cos));
  return {sine * std::cos(phi), sine * std::sin(phi), cos};
}

template <class T>
struct Cosine {
  [[nodiscard]] Vector<T> draw(const Vector<T>&, const Vector<T>& xi) const {
    return polar(std::sqrt(1 - xi[2]), 2 * Printed<T>::kPi * xi[1]);
  }
  [[nodiscard]] T pdf(const Vector<T>&, const Vector<T>& wo) const {
    return std::max(T(0), wo[2]) / Printed<T>::kPi;
  }
};

// Normals: D cos(theta) of Beckmann, of GGX and of a power; and of a power without the cosine
// (Ashikhmin & Shirley 2000, eq. 6 to 8).
template <class T>
struct Beckmann {
  T ax, ay;  // also of Ward's normals
  [[nodiscard]] Vector<T> draw(T u, T v) const {
    const T phi =
        std::atan2(ay * std::sin(2 * Printed<T>::kPi * u), ax * std::cos(2 * Printed<T>::kPi * u));
    const T c = std::cos(phi) / ax, s = std::sin(phi) / ay;
    return polar(1 / std::sqrt(1 - std::log(1 - v) / (c * c + s * s)), phi);
  }
  [[nodiscard]] T pdf(const Vector<T>& h) const {
    const T cos2 = h[2] * h[2], x = h[0] / ax, y = h[1] / ay;
    return std::exp(-(x * x + y * y) / cos2) / (Printed<T>::kPi * ax * ay * cos2 * h[2]);
  }
};
template <class T>
struct GgxNormals {
  T ax, ay;
  [[nodiscard]] Vector<T> draw(T u, T v) const {
    const T phi =
        std::atan2(ay * std::sin(2 * Printed<T>::kPi * u), ax * std::cos(2 * Printed<T>::kPi * u));
    const T c = std::cos(phi) / ax, s = std::sin(phi) / ay;
    return polar(1 / std::sqrt(1 + v / (1 - v) / (c * c + s * s)), phi);
  }
  [[nodiscard]] T pdf(const Vector<T>& h) const {
    const T x = h[0] / ax, y = h[1] / ay, s = x * x + y * y + h[2] * h[2];
    return h[2] / (Printed<T>::kPi * ax * ay * s * s);
  }
};
template <class T>
struct PowerNormals {
  T nu, nv;
  [[nodiscard]] Vector<T> draw(T u, T v) const {
    const T turn = 2 * Printed<T>::kPi * u;
    const T phi =
        std::atan2(std::sqrt(nu + 1) * std::sin(turn), std::sqrt(nv + 1) * std::cos(turn));
    const T c = std::cos(phi), s = std::sin(phi);
    return polar(std::pow(1 - v, 1 / (nu * c * c + nv * s * s + 1)), phi);
  }
  [[nodiscard]] T pdf(const Vector<T>& h) const {
    const T across = std::max(T(1e-30), 1 - h[2] * h[2]);
    const T e = (nu * h[0] * h[0] + nv * h[1] * h[1]) / across;
    return std::sqrt((nu + 1) * (nv + 1)) / (2 * Printed<T>::kPi) * std::pow(h[2], e);
  }
};

template <class T, class Normals>
struct ByHalfVector {
  Normals normals;
  [[nodiscard]] Vector<T> draw(const Vector<T>& wi, const Vector<T>& xi) const {
    const Vector<T> h = normals.draw(xi[1], xi[2]);
    const T twice = 2 * Printed<T>::dot(wi, h);
    return {twice * h[0] - wi[0], twice * h[1] - wi[1], twice * h[2] - wi[2]};
  }
  [[nodiscard]] T pdf(const Vector<T>& wi, const Vector<T>& wo) const {
    const Vector<T> h = Printed<T>::half(wi, wo);
    return wo[2] > 0 ? normals.pdf(h) / (4 * Printed<T>::dot(wi, h)) : T(0);
  }
};

// By a power of the cosine to the mirror direction.
template <class T>
struct AboutMirror {
  T s;
  [[nodiscard]] Vector<T> draw(const Vector<T>& wi, const Vector<T>& xi) const {
    const Vector<T> a = polar(std::pow(1 - xi[2], 1 / (s + 1)), 2 * Printed<T>::kPi * xi[1]);
    const Vector<T> z{-wi[0], -wi[1], wi[2]};
    const T length = std::hypot(wi[0], wi[1]);
    const Vector<T> y =
        length > 0 ? Vector<T>{-z[1] / length, z[0] / length, 0} : Vector<T>{0, 1, 0};
    const Vector<T> x{y[1] * z[2], -y[0] * z[2], y[0] * z[1] - y[1] * z[0]};
    Vector<T> wo;
    for (std::size_t c = 0; c < 3; ++c) wo[c] = a[0] * x[c] + a[1] * y[c] + a[2] * z[c];
    return wo;
  }
  [[nodiscard]] T pdf(const Vector<T>& wi, const Vector<T>& wo) const {
    return wo[2] > 0
               ? (s + 1) / (2 * Printed<T>::kPi) * std::pow(Printed<T>::mirror_cosine(wi, wo), s)
               : T(0);
  }
};

template <class T, class Lobe>
struct HalfCosine {
  Lobe lobe;
  [[nodiscard]] Vector<T> draw(const Vector<T>& wi, const Vector<T>& xi) const {
    return xi[0] < T(0.5) ? Cosine<T>().draw(wi, xi) : lobe.draw(wi, xi);
  }
  [[nodiscard]] T pdf(const Vector<T>& wi, const Vector<T>& wo) const {
    return T(0.5) * Cosine<T>().pdf(wi, wo) + T(0.5) * lobe.pdf(wi, wo);
  }
};

}  // namespace gonio::chart
