// What core_bench measures beside chart/cases.h: more channels, and a sum.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "chart/cases.h"

namespace gonio::bench {

using chart::model_cases;
using chart::ModelCase;

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
  for (const auto& model : model_cases<float>()) {
    const auto names = summed_lobes();
    if (std::find(names.begin(), names.end(), model.name) != names.end())
      sum.specular.push_back(*model.spec.model);
  }
  return sum;
}

}  // namespace gonio::bench
