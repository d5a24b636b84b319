// Directions for the client's tests: spread over both hemispheres, so that some pairs are flagged.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace gonio::test {

template <class T>
struct RandomPairs {
  std::vector<T> wi, wo;

  explicit RandomPairs(std::size_t count, unsigned seed = 1) : wi(3 * count), wo(3 * count) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (auto* directions : {&wi, &wo}) {
      for (std::size_t i = 0; i < directions->size(); i += 3) {
        const double x = normal(random), y = normal(random), z = normal(random) + 1;
        const double length = std::sqrt(x * x + y * y + z * z);
        (*directions)[i] = static_cast<T>(x / length);
        (*directions)[i + 1] = static_cast<T>(y / length);
        (*directions)[i + 2] = static_cast<T>(z / length);
      }
    }
  }
};

}  // namespace gonio::test
