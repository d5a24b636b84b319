// The models as a loop of one's own would have them: scalar, straight from the page, in the
// caller's type. This is what the kernels are timed against; it has the naive forms' errors on
// purpose.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace gonio::bench {

template <class T>
using Rgb = std::array<T, 3>;

template <class T>
struct Printed {
  using V = std::array<T, 3>;
  static constexpr T kPi = T(3.14159265358979323846);

  static T dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static V half(const V& a, const V& b) {
    const V h{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const T inverse = 1 / std::sqrt(dot(h, h));
    return {h[0] * inverse, h[1] * inverse, h[2] * inverse};
  }
  static T schlick(T f0, T c) { return f0 + (1 - f0) * std::pow(1 - c, T(5)); }

  static Rgb<T> lambertian(const V&, const V&) {
    return {T(0.1) / kPi, T(0.2) / kPi, T(0.3) / kPi};
  }

  static Rgb<T> ashikhmin_shirley(const V& wi, const V& wo) {
    constexpr Rgb<T> kRd{T(0.1), T(0.2), T(0.3)}, kRs{T(0.5), T(0.4), T(0.3)};
    const T nu = 100, nv = 10;
    const V h = half(wi, wo);
    const T hk = dot(h, wi);
    const T e = (nu * h[0] * h[0] + nv * h[1] * h[1]) / (1 - h[2] * h[2]);
    const T lobe = std::sqrt((nu + 1) * (nv + 1)) / (8 * kPi) * std::pow(h[2], e) /
                   (hk * std::max(wi[2], wo[2]));
    const T diffuse = (1 - std::pow(1 - wi[2] / 2, T(5))) * (1 - std::pow(1 - wo[2] / 2, T(5)));
    Rgb<T> f;
    for (std::size_t c = 0; c < 3; ++c) {
      f[c] = lobe * schlick(kRs[c], hk) + 28 * kRd[c] / (23 * kPi) * (1 - kRs[c]) * diffuse;
    }
    return f;
  }

  static Rgb<T> cook_torrance(const V& wi, const V& wo) {
    const T m = T(0.3);
    const V h = half(wi, wo);
    const T hk = dot(h, wi), cos2 = h[2] * h[2];
    const T d = std::exp(-(1 - cos2) / (cos2 * m * m)) / (kPi * m * m * cos2 * cos2);
    const T g = std::min({T(1), 2 * h[2] * wo[2] / hk, 2 * h[2] * wi[2] / hk});
    return coloured(d * g / (4 * wi[2] * wo[2]), hk);
  }

  static Rgb<T> ggx(const V& wi, const V& wo) {
    const T ax = T(0.3), ay = T(0.2);
    const V h = half(wi, wo);
    const T s = h[0] * h[0] / (ax * ax) + h[1] * h[1] / (ay * ay) + h[2] * h[2];
    const T d = 1 / (kPi * ax * ay * s * s);
    const auto stretched = [&](const V& w) {
      return std::sqrt(ax * ax * w[0] * w[0] + ay * ay * w[1] * w[1] + w[2] * w[2]);
    };
    return coloured(d / (2 * (wo[2] * stretched(wi) + wi[2] * stretched(wo))), dot(h, wi));
  }

  static T mirror_cosine(const V& wi, const V& wo) {
    return std::max(T(0), wi[2] * wo[2] - wi[0] * wo[0] - wi[1] * wo[1]);
  }

  static Rgb<T> phong(const V& wi, const V& wo) {
    const T s = 100;
    return coloured((s + 2) / (2 * kPi) * std::pow(mirror_cosine(wi, wo), s),
                    dot(half(wi, wo), wi));
  }

  static Rgb<T> blinn_phong(const V& wi, const V& wo) {
    const T s = 100;
    const V h = half(wi, wo);
    return coloured((s + 8) / (8 * kPi) * std::pow(h[2], s), dot(h, wi));
  }

  static Rgb<T> phong_mix(const V& wi, const V& wo) {
    const T s = 100, mix = T(0.4);
    const V h = half(wi, wo);
    const T base = (1 - mix) * mirror_cosine(wi, wo) + mix * h[2] * h[2] * h[2] * h[2];
    return coloured(std::pow(base, s), dot(h, wi));
  }

  static Rgb<T> cook_torrance_power(const V& wi, const V& wo) {
    const T s = 100;
    const V h = half(wi, wo);
    const T hk = dot(h, wi), d = (s + 2) / (2 * kPi) * std::pow(h[2], s);
    const T g = std::min({T(1), 2 * h[2] * wo[2] / hk, 2 * h[2] * wi[2] / hk});
    return coloured(d * g / (4 * wi[2] * wo[2]), hk);
  }

  static Rgb<T> ward(const V& wi, const V& wo) {
    const T ax = T(0.3), ay = T(0.2);
    const V h = half(wi, wo);
    const T hk = dot(h, wi), cos2 = h[2] * h[2];
    const T slope = (h[0] * h[0] / (ax * ax) + h[1] * h[1] / (ay * ay)) / cos2;
    const T lobe = std::exp(-slope) / (4 * kPi * ax * ay * hk * hk * cos2 * cos2);
    return {T(0.5) * lobe, T(0.4) * lobe, T(0.3) * lobe};
  }

  template <bool kFull>
  static Rgb<T> oren_nayar(const V& wi, const V& wo) {
    constexpr Rgb<T> kRd{T(0.1), T(0.2), T(0.3)};
    const T s2 = T(0.3) * T(0.3);
    const T ti = std::acos(wi[2]), to = std::acos(wo[2]);
    const T alpha = std::max(ti, to), beta = std::min(ti, to);
    const T cos_phi = std::cos(std::atan2(wi[1], wi[0]) - std::atan2(wo[1], wo[0]));
    const T c1 = 1 - T(0.5) * s2 / (s2 + T(0.33)), c2 = T(0.45) * s2 / (s2 + T(0.09));
    const T b = 2 * beta / kPi, ab = 4 * alpha * beta / (kPi * kPi);
    T once = c1 + c2 * std::max(T(0), cos_phi) * std::sin(alpha) * std::tan(beta), twice = 0;
    if constexpr (kFull) {
      const T bent = cos_phi < 0 ? std::sin(alpha) - b * b * b : std::sin(alpha);
      const T c3 = T(0.125) * s2 / (s2 + T(0.09)) * ab * ab;
      once = c1 + cos_phi * c2 * bent * std::tan(beta) +
             (1 - std::abs(cos_phi)) * c3 * std::tan((alpha + beta) / 2);
      twice = T(0.17) * s2 / (s2 + T(0.13)) * (1 - cos_phi * b * b);
    }
    Rgb<T> f;
    for (std::size_t c = 0; c < 3; ++c) f[c] = kRd[c] / kPi * (once + kRd[c] * twice);
    return f;
  }

  static Rgb<T> coloured(T lobe, T hk) {
    return {lobe * schlick(T(0.9), hk), lobe * schlick(T(0.8), hk), lobe * schlick(T(0.7), hk)};
  }
};

}  // namespace gonio::bench
