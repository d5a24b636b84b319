// The models as hand-written loops (assess/naive.h), each with fixed parameters that the compiler
// knows. The kernels' times are compared with theirs. They have the errors of the naive forms on
// purpose.
#pragma once

#include <array>

#include "assess/naive.h"

namespace gonio::chart {

template <class T>
using Rgb = std::array<T, 3>;

template <class T>
struct Printed : assess::Naive<T> {
  using Form = assess::Naive<T>;
  using V = std::array<T, 3>;
  using Form::dot;
  using Form::half;
  using Form::kPi;
  using Form::schlick;

  static Rgb<T> lambertian(const V&, const V&) {
    return {T(0.1) / kPi, T(0.2) / kPi, T(0.3) / kPi};
  }

  static Rgb<T> ashikhmin_shirley(const V& wi, const V& wo) {
    constexpr Rgb<T> kRd{T(0.1), T(0.2), T(0.3)}, kRs{T(0.5), T(0.4), T(0.3)};
    const V h = half(wi, wo);
    const T hk = dot(h, wi);
    const T lobe = Form::ashikhmin_shirley(wi, wo, h, hk, 100, 10);
    const T diffuse = Form::ashikhmin_shirley_diffuse(wi[2], wo[2]);
    Rgb<T> f;
    for (std::size_t c = 0; c < 3; ++c)
      f[c] = lobe * schlick(kRs[c], hk) + kRd[c] * (1 - kRs[c]) * diffuse;
    return f;
  }

  static Rgb<T> cook_torrance(const V& wi, const V& wo) {
    const V h = half(wi, wo);
    const T hk = dot(h, wi);
    return coloured(Form::cook_torrance(wi, wo, h, hk, Form::beckmann(h, T(0.3))), hk);
  }

  static Rgb<T> ggx(const V& wi, const V& wo) {
    const V h = half(wi, wo);
    return coloured(Form::ggx(wi, wo, h, T(0.3), T(0.2)), dot(h, wi));
  }

  static Rgb<T> phong(const V& wi, const V& wo) {
    return coloured(Form::phong(wi, wo, 100), dot(half(wi, wo), wi));
  }

  static Rgb<T> blinn_phong(const V& wi, const V& wo) {
    const V h = half(wi, wo);
    return coloured(Form::blinn_phong(h, 100), dot(h, wi));
  }

  static Rgb<T> phong_mix(const V& wi, const V& wo) {
    const V h = half(wi, wo);
    return coloured(Form::phong_mix(wi, wo, h, 100, T(0.4)), dot(h, wi));
  }

  static Rgb<T> cook_torrance_power(const V& wi, const V& wo) {
    const V h = half(wi, wo);
    const T hk = dot(h, wi);
    return coloured(Form::cook_torrance(wi, wo, h, hk, Form::cosine_power(h, 100)), hk);
  }

  static Rgb<T> ward(const V& wi, const V& wo) {
    const V h = half(wi, wo);
    const T lobe = Form::ward(h, dot(h, wi), T(0.3), T(0.2));
    return {T(0.5) * lobe, T(0.4) * lobe, T(0.3) * lobe};
  }

  template <bool kFull>
  static Rgb<T> oren_nayar(const V& wi, const V& wo) {
    constexpr Rgb<T> kRd{T(0.1), T(0.2), T(0.3)};
    const auto facets = Form::oren_nayar(wi, wo, T(0.3), kFull);
    Rgb<T> f;
    for (std::size_t c = 0; c < 3; ++c) f[c] = kRd[c] / kPi * (facets.once + kRd[c] * facets.twice);
    return f;
  }

  static Rgb<T> coloured(T lobe, T hk) {
    return {lobe * schlick(T(0.9), hk), lobe * schlick(T(0.8), hk), lobe * schlick(T(0.7), hk)};
  }
};

}  // namespace gonio::chart
