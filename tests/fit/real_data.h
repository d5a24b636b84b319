// Measured materials as a fit takes them.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>

#include "fit/data/data.h"
#include "gonio/measured/table.h"
#include "measured/npf_material.h"
#include "measured/synthetic_merl.h"

namespace gonio::testing {

// The eight that fits are judged by.
inline constexpr std::array kFitMaterials{
    "nickel", "two-layer-silver",    "violet-rubber", "red-fabric2",
    "chrome", "gold-metallic-paint", "blue-acrylic",  "white-diffuse-bball"};

// All cells of a material of $GONIO_DATA/merl, with multiplicative log-normal noise and a part of
// them not measured on request; nothing if the data are absent.
inline std::optional<fit::Data> load_measured(const std::string& name, double noise = 0,
                                              double invalid = 0) {
  const auto material = NpfMaterial::load(name);
  if (!material) return std::nullopt;
  std::vector<float> values = tabulate(*material);
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  for (std::size_t i = 0; noise > 0 && i < values.size(); i += 3) {
    const bool drop = uniform(random) < invalid;
    const double factor = std::exp(noise * normal(random));
    for (std::size_t c = 0; c < 3; ++c)
      values[i + c] = drop ? -1 : static_cast<float>(static_cast<double>(values[i + c]) * factor);
  }
  return fit::from_table(**MeasuredTable::from_values(values));
}

// A diffuse base and one lobe with a Fresnel term ("" for a model that has its own).
inline MaterialSpec over_lambertian(const std::string& model, const std::string& fresnel) {
  MaterialSpec form;
  form.diffuse = LobeSpec{"lambertian", {}};
  form.specular = {LobeSpec{model, {}}};
  if (!fresnel.empty()) form.specular[0].parameters["fresnel"] = fresnel;
  return form;
}

// Shapes anywhere that a person might start from.
inline void draw_start(std::mt19937_64& random, LobeSpec& lobe) {
  std::uniform_real_distribution<double> uniform;
  const auto between = [&](double low, double high) {
    return std::vector{low * std::pow(high / low, uniform(random))};
  };
  lobe.parameters["eta"] = std::vector{1 + between(0.05, 20)[0]};
  if (lobe.model == "cook_torrance") {
    lobe.parameters["m"] = between(3e-3, 1);
  } else {
    lobe.parameters["s"] = between(0.5, 1e5);
  }
  if (lobe.model == "phong_mix") lobe.parameters["mix"] = std::vector{uniform(random)};
}

}  // namespace gonio::testing
