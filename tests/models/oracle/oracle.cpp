#include "models/oracle/oracle.h"

#include <stdexcept>
#include <string>

namespace gonio::testing {
namespace {

enum class Reflectance { none, schlick, dielectric, conductor };

// The word that is given, else what the other parameters imply.
Reflectance reflectance_of(const LobeSpec& spec) {
  static const std::map<std::string, Reflectance> kWords{{"none", Reflectance::none},
                                                         {"schlick", Reflectance::schlick},
                                                         {"dielectric", Reflectance::dielectric},
                                                         {"conductor", Reflectance::conductor}};
  if (const auto word = spec.parameters.find("fresnel"); word != spec.parameters.end()) {
    return kWords.at(std::get<std::string>(word->second));
  }
  if (spec.parameters.contains("f0")) return Reflectance::schlick;
  if (spec.parameters.contains("k")) return Reflectance::conductor;
  if (spec.parameters.contains("eta")) return Reflectance::dielectric;
  return Reflectance::none;
}

}  // namespace

template <class Real>
struct Oracle<Real>::Lobe {
  std::string model;
  Reflectance reflectance;
  bool full;  // of Oren and Nayar's forms
  std::map<std::string, std::vector<double>> numbers;

  [[nodiscard]] Real at(const std::string& name, std::size_t channel = 0) const {
    const std::vector<double>& values = numbers.at(name);
    return static_cast<Real>(values.at(values.size() == 1 ? 0 : channel));
  }
};

template <class Real>
typename Oracle<Real>::Lobe Oracle<Real>::lobe_of(const LobeSpec& spec) {
  const auto form = spec.parameters.find("form");
  const bool is_short =
      form != spec.parameters.end() && std::get<std::string>(form->second) == "short";
  Lobe lobe{spec.model, reflectance_of(spec), !is_short, {{"scale", {1.0}}}};
  for (const auto& [name, value] : spec.parameters) {
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
      lobe.numbers[name] = *numbers;
    }
  }
  return lobe;
}

template <class Real>
Oracle<Real>::Oracle(const MaterialSpec& spec) : rotation_(spec.rotation.value_or(0)) {
  std::vector<Lobe> lobes;
  if (spec.model) lobes.push_back(lobe_of(*spec.model));
  if (spec.diffuse) lobes.push_back(lobe_of(*spec.diffuse));
  for (const LobeSpec& lobe : spec.specular) lobes.push_back(lobe_of(lobe));
  for (const Lobe& lobe : lobes) {
    for (const auto& [name, values] : lobe.numbers) channels_ = std::max(channels_, values.size());
  }
  lobes_ = std::make_shared<const std::vector<Lobe>>(std::move(lobes));
}

template <class Real>
Real Oracle<Real>::fresnel(const Lobe& lobe, Real c, std::size_t channel) {
  switch (lobe.reflectance) {
    case Reflectance::none:
      return 1;
    case Reflectance::schlick:
      return schlick(c, lobe.at("f0", channel));
    case Reflectance::dielectric:
      return dielectric(c, lobe.at("eta", channel));
    case Reflectance::conductor:
      return conductor(c, lobe.at("eta", channel), lobe.at("k", channel));
  }
  throw std::logic_error("no such reflectance");
}

// The part of a specular lobe that all channels share.
template <class Real>
Real Oracle<Real>::without_fresnel(const Lobe& lobe, const Pair& pair) {
  const auto& [wi, wo, h, hk] = pair;
  if (lobe.model == "ashikhmin_shirley") {
    return anisotropic_phong(h, lobe.at("nu"), lobe.at("nv")) / (hk * std::max(wi.z, wo.z));
  }
  if (lobe.model == "cook_torrance") {
    const Real d =
        lobe.numbers.contains("s") ? cosine_power(h, lobe.at("s")) : beckmann(h, lobe.at("m"));
    return d * v_groove(wi.z, wo.z, h.z, hk) / (4 * wi.z * wo.z);
  }
  if (lobe.model == "ggx") {
    const Real ax = lobe.at("alpha_x"), ay = lobe.at("alpha_y");
    const Real shadowing = 1 / (1 + smith_lambda(wi, ax, ay) + smith_lambda(wo, ax, ay));
    return trowbridge_reitz(h, ax, ay) * shadowing / (4 * wi.z * wo.z);
  }
  if (lobe.model == "phong") return phong(wi, wo, lobe.at("s"));
  if (lobe.model == "blinn_phong") return blinn_phong(h, lobe.at("s"));
  if (lobe.model == "phong_mix") return phong_mix(wi, wo, h, lobe.at("s"), lobe.at("mix"));
  if (lobe.model == "ward") return ward(h, hk, lobe.at("alpha_x"), lobe.at("alpha_y"));
  throw std::out_of_range("no oracle for the model " + lobe.model);
}

// Channel `c` of a lobe, given what all channels share of it.
template <class Real>
Real Oracle<Real>::channel(const Lobe& lobe, const Pair& pair, Real shared, std::size_t c) {
  if (lobe.model == "lambertian") return lobe.at("rd", c) / pi<Real>();
  if (lobe.model == "ashikhmin_shirley") {
    const Real rs = lobe.at("rs", c), diffuse = coupled_diffuse(pair.wi.z, pair.wo.z);
    return lobe.at("scale", c) * shared * schlick(pair.hk, rs) +
           lobe.at("rd", c) * (1 - rs) * diffuse;
  }
  const Real colour = lobe.model == "ward" ? lobe.at("rs", c) : fresnel(lobe, pair.hk, c);
  return lobe.at("scale", c) * shared * colour;
}

template <class Real>
void Oracle<Real>::add(const Lobe& lobe, const Pair& pair, std::span<Real> f) {
  if (lobe.model == "oren_nayar") {
    const auto facets = oren_nayar(pair.wi, pair.wo, lobe.at("sigma"), lobe.full);
    for (std::size_t c = 0; c < f.size(); ++c) {
      const Real rd = lobe.at("rd", c);
      f[c] += std::max(Real(0), rd / pi<Real>() * (facets.once + rd * facets.twice));
    }
    return;
  }
  const Real shared = lobe.model == "lambertian" ? Real(0) : without_fresnel(lobe, pair);
  for (std::size_t c = 0; c < f.size(); ++c) f[c] += channel(lobe, pair, shared, c);
}

template <class Real>
void Oracle<Real>::evaluate(Vec<Real> wi, Vec<Real> wo, std::span<Real> f) const {
  std::ranges::fill(f, Real(0));
  if (!(wi.z > 0 && wo.z > 0)) return;
  const Real li = root(dot(wi, wi)), lo = root(dot(wo, wo));
  const Vec<Real> twice = sum_of_normalized(wi, li, wo, lo);
  const Real length = root(dot(twice, twice));
  const auto seen = [&](const Vec<Real>& w) { return turned(w, -rotation_); };
  const Pair pair{seen(divided(wi, li)), seen(divided(wo, lo)), seen(divided(twice, length)),
                  length / 2};
  for (const Lobe& lobe : *lobes_) add(lobe, pair, f);
}

template class Oracle<Quad>;
template class Oracle<long double>;

}  // namespace gonio::testing
