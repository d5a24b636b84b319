#include "models/oracle/density_oracle.h"

#include <stdexcept>

#include "gonio/engine/registry.h"
#include "models/sampling/sampling_subject.h"

namespace gonio::testing {
namespace {

using densities::Real;
using densities::Vector;

Real at(const LobeSpec& lobe, const std::string& name) {
  return std::get<std::vector<double>>(lobe.parameters.at(name)).front();
}

Real density(const LobeSpec& lobe, const Vector& wi, const Vector& wo, const Vector& h, Real hk) {
  if (lobe.model == "ashikhmin_shirley")
    return densities::ashikhmin_shirley(wi, h, hk, at(lobe, "nu"), at(lobe, "nv"));
  if (lobe.model == "blinn_phong") return densities::blinn_phong(wi, h, hk, at(lobe, "s"));
  if (lobe.model == "cook_torrance") {
    if (lobe.parameters.contains("s")) {
      const Real s = at(lobe, "s");
      return densities::v_cavities(wi, h, hk, cosine_power(h, s), densities::Power{s + 2});
    }
    const Real m = at(lobe, "m");
    return densities::v_cavities(wi, h, hk, beckmann(h, m), densities::Slope{1 / (m * m)});
  }
  if (lobe.model == "ggx")
    return densities::bounded_ggx(wi, h, at(lobe, "alpha_x"), at(lobe, "alpha_y"));
  if (lobe.model == "phong") return densities::phong(wi, wo, at(lobe, "s"));
  if (lobe.model == "phong_mix") {
    const Real s = at(lobe, "s"), mix = at(lobe, "mix");
    return (1 - mix) * densities::phong(wi, wo, s) + mix * densities::blinn_phong(wi, h, hk, 4 * s);
  }
  if (lobe.model == "ward")
    return densities::ward(wi, h, hk, at(lobe, "alpha_x"), at(lobe, "alpha_y"));
  throw std::out_of_range("no density for the model " + lobe.model);
}

bool is_diffuse(const LobeSpec& lobe) { return (*find_model(lobe.model))->role == Role::diffuse; }

}  // namespace

DensityOracle::DensityOracle(const MaterialSpec& spec, Sampler sampler)
    : lobes_(spec.specular), sampler_(std::move(sampler)), rotation_(spec.rotation.value_or(0)) {
  if (spec.model && !is_diffuse(*spec.model)) lobes_.push_back(*spec.model);
}

long double DensityOracle::operator()(const Vector& wi, const Vector& wo) const {
  const Real li = root(dot(wi, wi)), lo = root(dot(wo, wo));
  const Vector twice = sum_of_normalized(wi, li, wo, lo);
  const Real length = root(dot(twice, twice));
  const auto seen = [&](const Vector& w) { return turned(w, -rotation_); };
  const Vector i = seen(divided(wi, li)), o = seen(divided(wo, lo)),
               h = seen(divided(twice, length));
  const std::vector<double> shares = shares_of(sampler_, static_cast<double>(i.z));
  Real sum = 0;
  for (std::size_t k = 0; k < lobes_.size(); ++k)
    sum += shares[k] * density(lobes_[k], i, o, h, length / 2);
  if (shares.size() > lobes_.size()) sum += shares.back() * o.z / pi<Real>();
  return sum;
}

}  // namespace gonio::testing
