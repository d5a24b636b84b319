// What core_bench measures: a material of each model, and its form as printed with the same
// parameters.
#pragma once

#include <functional>
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
  };
}

}  // namespace gonio::bench
