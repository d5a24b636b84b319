// What core_bench measures: a material of each model, and its form as printed with the same
// parameters.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/printed.h"
#include "engine/material.h"

namespace gonio::bench {

template <class T>
struct BenchCase {
  std::string name;
  MaterialSpec spec;
  std::array<T, 3> (*printed)(const std::array<T, 3>& wi, const std::array<T, 3>& wo);
};

template <class T>
std::vector<BenchCase<T>> bench_cases() {
  using Numbers = std::vector<double>;
  const auto alone = [](LobeSpec lobe) {
    return MaterialSpec{.model = std::move(lobe), .diffuse = {}, .specular = {}};
  };
  const Numbers metal{0.9, 0.8, 0.7};
  return {
      {"lambertian", alone({"lambertian", {{"rd", Numbers{0.1, 0.2, 0.3}}}}),
       &Printed<T>::lambertian},
      {"ashikhmin_shirley",
       alone({"ashikhmin_shirley",
              {{"rd", Numbers{0.1, 0.2, 0.3}},
               {"rs", Numbers{0.5, 0.4, 0.3}},
               {"nu", Numbers{100}},
               {"nv", Numbers{10}}}}),
       &Printed<T>::ashikhmin_shirley},
      {"cook_torrance", alone({"cook_torrance", {{"m", Numbers{0.3}}, {"f0", metal}}}),
       &Printed<T>::cook_torrance},
      {"ggx", alone({"ggx", {{"alpha_x", Numbers{0.3}}, {"alpha_y", Numbers{0.2}}, {"f0", metal}}}),
       &Printed<T>::ggx},
      {"phong", alone({"phong", {{"s", Numbers{100}}, {"f0", metal}}}), &Printed<T>::phong},
      {"blinn_phong", alone({"blinn_phong", {{"s", Numbers{100}}, {"f0", metal}}}),
       &Printed<T>::blinn_phong},
      {"phong_mix",
       alone({"phong_mix", {{"s", Numbers{100}}, {"mix", Numbers{0.4}}, {"f0", metal}}}),
       &Printed<T>::phong_mix},
      {"cook_torrance s", alone({"cook_torrance", {{"s", Numbers{100}}, {"f0", metal}}}),
       &Printed<T>::cook_torrance_power},
      {"oren_nayar full",
       alone({"oren_nayar", {{"rd", Numbers{0.1, 0.2, 0.3}}, {"sigma", Numbers{0.3}}}}),
       &Printed<T>::template oren_nayar<true>},
      {"oren_nayar short",
       alone({"oren_nayar",
              {{"rd", Numbers{0.1, 0.2, 0.3}}, {"sigma", Numbers{0.3}}, {"form", "short"}}}),
       &Printed<T>::template oren_nayar<false>},
      {"ward",
       alone({"ward",
              {{"rs", Numbers{0.5, 0.4, 0.3}},
               {"alpha_x", Numbers{0.3}},
               {"alpha_y", Numbers{0.2}}}}),
       &Printed<T>::ward},
  };
}

// The same material with 64 channels, its colours spread from their first value to their last.
inline MaterialSpec spectral(MaterialSpec spec) {
  for (auto& [name, value] : spec.model->parameters) {
    auto* numbers = std::get_if<std::vector<double>>(&value);
    if (numbers == nullptr || numbers->size() != 3) continue;
    std::vector<double> spread;
    for (int c = 0; c < kMaxChannels; ++c)
      spread.push_back(std::lerp(numbers->front(), numbers->back(), c / (kMaxChannels - 1.0)));
    *numbers = std::move(spread);
  }
  return spec;
}

// Four lobes, and their sum.
inline std::vector<std::string> summed_lobes() {
  return {"ashikhmin_shirley", "cook_torrance", "ggx", "blinn_phong"};
}
inline MaterialSpec sum_of_lobes() {
  MaterialSpec sum;
  for (const auto& model : bench_cases<float>()) {
    const auto names = summed_lobes();
    if (std::find(names.begin(), names.end(), model.name) != names.end())
      sum.specular.push_back(*model.spec.model);
  }
  return sum;
}

}  // namespace gonio::bench
