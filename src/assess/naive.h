// The models as a hand-written loop has them: scalar, as the papers print them, in the caller's
// type T, with directions as given. The formulas are right. Their arithmetic has, on purpose, the
// errors that the kernels avoid: the kernels are compared with it for speed and accuracy.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace gonio::assess {

template <class T>
struct Naive {
  using V = std::array<T, 3>;
  static constexpr T kPi = T(std::numbers::pi);

  static T dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static V half(const V& a, const V& b) {
    const V h{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const T inverse = 1 / std::sqrt(dot(h, h));
    return {h[0] * inverse, h[1] * inverse, h[2] * inverse};
  }
  static T mirror_cosine(const V& wi, const V& wo) {
    return std::max(T(0), wi[2] * wo[2] - wi[0] * wo[0] - wi[1] * wo[1]);
  }

  static T schlick(T f0, T c) { return f0 + (1 - f0) * std::pow(1 - c, T(5)); }

  // Cook & Torrance's form.
  static T dielectric(T eta, T c) {
    const T g = std::sqrt(eta * eta - 1 + c * c);
    const T a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
    return a * a * (1 + b * b) / 2;
  }

  static T conductor(T eta, T k, T c) {
    const std::complex<T> index(eta, k), square = index * index;
    const std::complex<T> r = std::sqrt(square - T(1) + c * c);
    const std::complex<T> s = (c - r) / (c + r), p = (square * c - r) / (square * c + r);
    return (std::norm(s) + std::norm(p)) / 2;
  }

  static T ashikhmin_shirley(const V& wi, const V& wo, const V& h, T hk, T nu, T nv) {
    const T e = (nu * h[0] * h[0] + nv * h[1] * h[1]) / (1 - h[2] * h[2]);
    return std::sqrt((nu + 1) * (nv + 1)) / (8 * kPi) * std::pow(h[2], e) /
           (hk * std::max(wi[2], wo[2]));
  }
  // The factor of rd (1 - rs).
  static T ashikhmin_shirley_diffuse(T cos_i, T cos_o) {
    return 28 / (23 * kPi) * (1 - std::pow(1 - cos_i / 2, T(5))) *
           (1 - std::pow(1 - cos_o / 2, T(5)));
  }

  static T beckmann(const V& h, T m) {
    const T cos2 = h[2] * h[2];
    return std::exp(-(1 - cos2) / (cos2 * m * m)) / (kPi * m * m * cos2 * cos2);
  }
  static T cosine_power(const V& h, T s) { return (s + 2) / (2 * kPi) * std::pow(h[2], s); }
  // d: the distribution of normals at h.
  static T cook_torrance(const V& wi, const V& wo, const V& h, T hk, T d) {
    const T g = std::min({T(1), 2 * h[2] * wo[2] / hk, 2 * h[2] * wi[2] / hk});
    return d * g / (4 * wi[2] * wo[2]);
  }

  static T ggx(const V& wi, const V& wo, const V& h, T ax, T ay) {
    const T s = h[0] * h[0] / (ax * ax) + h[1] * h[1] / (ay * ay) + h[2] * h[2];
    const T d = 1 / (kPi * ax * ay * s * s);
    const auto stretched = [&](const V& w) {
      return std::sqrt(ax * ax * w[0] * w[0] + ay * ay * w[1] * w[1] + w[2] * w[2]);
    };
    return d / (2 * (wo[2] * stretched(wi) + wi[2] * stretched(wo)));
  }

  static T phong(const V& wi, const V& wo, T s) {
    return (s + 2) / (2 * kPi) * std::pow(mirror_cosine(wi, wo), s);
  }
  static T blinn_phong(const V& h, T s) {
    return (s + 2) * (s + 4) / (8 * kPi * (std::pow(T(2), -s / 2) + s)) * std::pow(h[2], s);
  }
  static T phong_mix(const V& wi, const V& wo, const V& h, T s, T mix) {
    const T base = (1 - mix) * mirror_cosine(wi, wo) + mix * h[2] * h[2] * h[2] * h[2];
    return std::pow(base, s);
  }

  static T ward(const V& h, T hk, T ax, T ay) {
    const T cos2 = h[2] * h[2];
    const T slope = (h[0] * h[0] / (ax * ax) + h[1] * h[1] / (ay * ay)) / cos2;
    return std::exp(-slope) / (4 * kPi * ax * ay * hk * hk * cos2 * cos2);
  }

  // The factors of rd/pi and of rd^2/pi.
  struct Facets {
    T once, twice;
  };
  static Facets oren_nayar(const V& wi, const V& wo, T sigma, bool full) {
    const T s2 = sigma * sigma;
    const T ti = std::acos(wi[2]), to = std::acos(wo[2]);
    const T alpha = std::max(ti, to), beta = std::min(ti, to);
    const T cos_phi = std::cos(std::atan2(wi[1], wi[0]) - std::atan2(wo[1], wo[0]));
    const T c1 = 1 - T(0.5) * s2 / (s2 + T(0.33)), c2 = T(0.45) * s2 / (s2 + T(0.09));
    if (!full) return {c1 + c2 * std::max(T(0), cos_phi) * std::sin(alpha) * std::tan(beta), 0};
    const T b = 2 * beta / kPi, ab = 4 * alpha * beta / (kPi * kPi);
    const T bent = cos_phi < 0 ? std::sin(alpha) - b * b * b : std::sin(alpha);
    const T c3 = T(0.125) * s2 / (s2 + T(0.09)) * ab * ab;
    return {c1 + cos_phi * c2 * bent * std::tan(beta) +
                (1 - std::abs(cos_phi)) * c3 * std::tan((alpha + beta) / 2),
            T(0.17) * s2 / (s2 + T(0.13)) * (1 - cos_phi * b * b)};
  }
};

}  // namespace gonio::assess
