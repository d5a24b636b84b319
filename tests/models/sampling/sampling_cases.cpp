#include "models/sampling/sampling_cases.h"

#include <cmath>
#include <numbers>

#include "gonio/engine/registry.h"

namespace gonio::testing {
namespace {

const std::vector<double> kThetas{0, 30, 60, 80, 89, 89.9}, kFewThetas{60, 89.9};

bool has_fresnel(const MaterialSpec& spec) {
  if (!spec.model) return false;
  const auto fresnel = spec.model->parameters.find("fresnel");
  return fresnel != spec.model->parameters.end() &&
         std::get<std::string>(fresnel->second) != "none";
}

bool is_anisotropic(const LobeSpec& lobe) {
  const auto& [u, v] = (*find_model(lobe.model))->along_tangents;
  const auto along_u = lobe.parameters.find(u), along_v = lobe.parameters.find(v);
  return along_u != lobe.parameters.end() && along_u->second != along_v->second;
}

bool is_anisotropic(const MaterialSpec& spec) {
  return (spec.model && is_anisotropic(*spec.model)) ||
         std::ranges::any_of(spec.specular, [](const auto& l) { return is_anisotropic(l); });
}

Draw turned(Draw draw, double degrees) {
  draw.name += ", turned";
  draw.spec.rotation = degrees;
  return draw;
}

// All places of the range without a Fresnel factor, and a turned one of an anisotropic model; with
// each kind of Fresnel factor, a random place.
std::vector<Draw> materials_of(const std::string& model) {
  std::vector<Draw> draws;
  if (model == "sum") {
    for (Case& c : cases_of(model)) draws.push_back({std::move(c.name), std::move(c.spec)});
    return draws;
  }
  for (Draw& draw : draws_of(**find_model(model))) {
    if (!has_fresnel(draw.spec) && is_anisotropic(draw.spec) && draw.name.starts_with("random"))
      draws.push_back(turned(draw, -40));
    if (!has_fresnel(draw.spec) || draw.name.starts_with("random,"))
      draws.push_back(std::move(draw));
  }
  return draws;
}

}  // namespace

Direction incidence(double theta, double phi) {
  const double t = theta * std::numbers::pi / 180, p = phi * std::numbers::pi / 180;
  const auto rounded = [](double v) { return static_cast<double>(static_cast<float>(v)); };
  return {rounded(std::sin(t) * std::cos(p)), rounded(std::sin(t) * std::sin(p)),
          rounded(std::cos(t))};
}

std::vector<Place> places_of(const std::string& model) {
  std::vector<Place> places;
  for (const Draw& draw : materials_of(model)) {
    // A Fresnel factor changes shares and weights, but no lobe's density.
    for (const double theta : has_fresnel(draw.spec) ? kFewThetas : kThetas) {
      std::vector<double> azimuths{25};
      if (theta > 0 && is_anisotropic(draw.spec)) azimuths = {0, 65};
      for (const double phi : azimuths) {
        const std::string where =
            draw.name + ", " + std::to_string(theta) + " " + std::to_string(phi) + " degrees";
        places.push_back({where, draw.spec, incidence(theta, phi), 2000 + places.size()});
      }
    }
  }
  return places;
}

std::size_t count_of_places() {
  static const std::size_t count = [] {
    std::size_t sum = 0;
    for (const std::string& model : models_with_cases()) sum += places_of(model).size();
    return sum;
  }();
  return count;
}

}  // namespace gonio::testing
