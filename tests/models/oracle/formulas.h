// The formulas of the models as the corrected sheet has them, for the oracle and the errata tests.
//
// Written from the formulas alone and sharing nothing with src/: naive on purpose, they are exact
// because their number type is.
#pragma once

#include <algorithm>

#include "models/oracle/real.h"

namespace gonio::testing {

template <class Real>
struct Vec {
  Real x, y, z;
};

template <class Real>
Real dot(const Vec<Real>& a, const Vec<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
Vec<Real> sum(const Vec<Real>& a, const Vec<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Real>
Vec<Real> divided(const Vec<Real>& a, Real by) {
  return {a.x / by, a.y / by, a.z / by};
}

template <class Real>
Vec<Real> normalized(const Vec<Real>& a) {
  return divided(a, root(dot(a, a)));
}

// Turned about the normal by so many degrees, counter-clockwise seen from above.
template <class Real>
Vec<Real> turned(const Vec<Real>& a, Real degrees) {
  const Real angle = degrees * pi<Real>() / 180, c = cosine(angle), s = sine(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y, a.z};
}

// wi/|wi| + wo/|wo| of directions of any length, right to a relative rounding even where the two
// nearly cancel: a/|a| + b/|b| = (a + b)/|a| + b (|a| - |b|)/(|a||b|), and |a|^2 - |b|^2 =
// (a - b).(a + b), in which a + b is exact. la and lb are the lengths.
template <class Real>
Vec<Real> sum_of_normalized(const Vec<Real>& a, Real la, const Vec<Real>& b, Real lb) {
  const Vec<Real> s = sum(a, b);
  const Real t = dot({a.x - b.x, a.y - b.y, a.z - b.z}, s) / ((la + lb) * la * lb);
  return {s.x / la + b.x * t, s.y / la + b.y * t, s.z / la + b.z * t};
}

template <class Real>
Real schlick(Real c, Real f0) {
  const Real r = 1 - c;
  return f0 + (1 - f0) * r * r * r * r * r;
}

// Unpolarised reflectance of a dielectric boundary, in the form of Cook and Torrance with
// g - c = (eta^2 - 1)/(g + c), or rounding would reflect where eta is 1.
template <class Real>
Real dielectric(Real c, Real eta) {
  const Real contrast = (eta - 1) * (eta + 1);
  const Real g2 = contrast + c * c;
  if (g2 < 0) return 1;
  const Real g = root(g2);
  const Real difference = contrast / (g + c);
  const Real a = difference / (g + c);
  const Real b = (c * (g + c) - 1) / (c * difference + 1);
  return a * a * (1 + b * b) / 2;
}

// Unpolarised reflectance of a boundary of refractive index N = eta + i k: half of |rs|^2 + |rp|^2
// with rs = (c - r)/(c + r), rp = (N^2 c - r)/(N^2 c + r), r = sqrt(N^2 - 1 + c^2).
template <class Real>
Real conductor(Real c, Real eta, Real k) {
  const Real n2_re = eta * eta - k * k;
  const Real n2_im = 2 * eta * k;
  const Real re2 = n2_re - 1 + c * c;
  const Real modulus = root(re2 * re2 + n2_im * n2_im);
  // The square root's parts, each without cancellation.
  Real re = root((modulus + (re2 < 0 ? -re2 : re2)) / 2);
  Real im = re > 0 ? n2_im / (2 * re) : Real(0);
  if (re2 < 0) std::swap(re, im);
  const auto ratio = [&](Real a_re, Real a_im) {
    const Real minus = (a_re - re) * (a_re - re) + (a_im - im) * (a_im - im);
    const Real plus = (a_re + re) * (a_re + re) + (a_im + im) * (a_im + im);
    return minus / plus;
  };
  return (ratio(c, 0) + ratio(n2_re * c, n2_im * c)) / 2;
}

// The cosine between wo and the mirror image of wi, or 0.
template <class Real>
Real mirror_cosine(const Vec<Real>& wi, const Vec<Real>& wo) {
  return std::max(Real(0), wi.z * wo.z - wi.x * wo.x - wi.y * wo.y);
}

// Phong's lobe with the norm that makes its albedo 1 at normal incidence.
template <class Real>
Real phong(const Vec<Real>& wi, const Vec<Real>& wo, Real s) {
  return (s + 2) / (2 * pi<Real>()) * power(mirror_cosine(wi, wo), s);
}

// Blinn's lobe with the norm that makes its albedo 1 at normal incidence.
template <class Real>
Real blinn_phong(const Vec<Real>& h, Real s) {
  const Real norm = (s + 2) * (s + 4) / (8 * pi<Real>() * (power(Real(2), -s / 2) + s));
  return norm * power(h.z, s);
}

// The power of a mean of both cosines of Nielsen and others.
template <class Real>
Real phong_mix(const Vec<Real>& wi, const Vec<Real>& wo, const Vec<Real>& h, Real s, Real mix) {
  const Real cos2 = h.z * h.z;
  return power((1 - mix) * mirror_cosine(wi, wo) + mix * cos2 * cos2, s);
}

// Oren and Nayar's diffuse reflection: the factors of rd/pi and of rd^2/pi.
template <class Real>
struct Facets {
  Real once, twice;
};
template <class Real>
Facets<Real> oren_nayar(const Vec<Real>& wi, const Vec<Real>& wo, Real sigma, bool full) {
  const Real s2 = sigma * sigma, pi_half = pi<Real>() / 2;
  const auto sine = [](const Vec<Real>& w) { return root(w.x * w.x + w.y * w.y); };
  const Real si = sine(wi), so = sine(wo);
  const Real ti = arctangent(si, wi.z), to = arctangent(so, wo.z);
  const Real sin_a = ti < to ? so : si, beta = std::min(ti, to), alpha = std::max(ti, to);
  const Real tan_b = ti < to ? si / wi.z : so / wo.z;
  const Real product = si * so;
  const Real cos_phi = product > 0 ? (wi.x * wo.x + wi.y * wo.y) / product : Real(0);
  const Real c1 = 1 - s2 / (s2 + static_cast<Real>(0.33)) / 2;
  const Real ratio = s2 / (s2 + static_cast<Real>(0.09));
  const Real c2 = static_cast<Real>(0.45) * ratio;
  if (!full) return {c1 + c2 * std::max(Real(0), cos_phi) * sin_a * tan_b, 0};
  const Real b = beta / pi_half, ab = alpha * beta / (pi_half * pi_half);
  const Real second = cos_phi * tan_b * (cos_phi < 0 ? sin_a - b * b * b : sin_a);
  const Real absolute = cos_phi < 0 ? -cos_phi : cos_phi;
  const Real third = (1 - absolute) * ratio / 8 * ab * ab * (si + so) / (wi.z + wo.z);
  const Real again = static_cast<Real>(0.17) * s2 / (s2 + static_cast<Real>(0.13));
  return {c1 + c2 * second + third, again * (1 - cos_phi * b * b)};
}

// Normal distribution of Beckmann, slope m.
template <class Real>
Real beckmann(const Vec<Real>& h, Real m) {
  const Real cos2 = h.z * h.z;
  const Real tan2 = (h.x * h.x + h.y * h.y) / cos2;
  return exponential(-tan2 / (m * m)) / (pi<Real>() * m * m * cos2 * cos2);
}

// Ward's lobe with the denominator that bounds its albedo.
template <class Real>
Real ward(const Vec<Real>& h, Real hk, Real alpha_x, Real alpha_y) {
  const Real cos2 = h.z * h.z;
  const Real a = h.x / alpha_x, b = h.y / alpha_y;
  return exponential(-(a * a + b * b) / cos2) /
         (4 * pi<Real>() * alpha_x * alpha_y * hk * hk * cos2 * cos2);
}

// Normal distribution as a cosine power.
template <class Real>
Real cosine_power(const Vec<Real>& h, Real s) {
  return (s + 2) / (2 * pi<Real>()) * power(h.z, s);
}

// Masking and shadowing of V-grooves (Torrance and Sparrow); hk = h.wi = h.wo.
template <class Real>
Real v_groove(Real n_wi, Real n_wo, Real n_h, Real hk) {
  const Real masking = 2 * n_h * n_wo / hk;
  const Real shadowing = 2 * n_h * n_wi / hk;
  return std::min(Real(1), std::min(masking, shadowing));
}

// Anisotropic Trowbridge-Reitz (GGX) distribution of normals.
template <class Real>
Real trowbridge_reitz(const Vec<Real>& h, Real alpha_x, Real alpha_y) {
  const Real a = h.x / alpha_x, b = h.y / alpha_y;
  const Real s = a * a + b * b + h.z * h.z;
  return 1 / (pi<Real>() * alpha_x * alpha_y * s * s);
}

// Smith's Lambda for the same.
template <class Real>
Real smith_lambda(const Vec<Real>& w, Real alpha_x, Real alpha_y) {
  const Real a = alpha_x * w.x, b = alpha_y * w.y;
  return (root(1 + (a * a + b * b) / (w.z * w.z)) - 1) / 2;
}

// (n.h)^e with the exponent of Ashikhmin and Shirley, and its normalisation over 8 pi.
template <class Real>
Real anisotropic_phong(const Vec<Real>& h, Real nu, Real nv) {
  const Real sin2 = h.x * h.x + h.y * h.y;
  const Real e = sin2 > 0 ? (nu * h.x * h.x + nv * h.y * h.y) / sin2 : Real(0);
  return root((nu + 1) * (nv + 1)) / (8 * pi<Real>()) * power(h.z, e);
}

// 28/(23 pi) (1 - (1 - n.k1/2)^5) (1 - (1 - n.k2/2)^5), the diffuse part of Ashikhmin and Shirley,
// multiplied out so that it keeps its digits at any cosine.
template <class Real>
Real coupled_diffuse(Real cos_i, Real cos_o) {
  const auto part = [](Real z) {
    const Real w = z / 2;
    return w * (5 - w * (10 - w * (10 - w * (5 - w))));
  };
  return 28 / (23 * pi<Real>()) * part(cos_i) * part(cos_o);
}

}  // namespace gonio::testing
