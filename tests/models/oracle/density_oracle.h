// The density of a whole material's samples, from the strategies of its lobes (densities.h) and the
// shares that its sampler gives them: what the sampler's pdf is held against.
#pragma once

#include <vector>

#include "gonio/engine/sampler.h"
#include "models/oracle/densities.h"

namespace gonio::testing {

class DensityOracle {
 public:
  // Throws std::out_of_range for a model whose strategy it does not know.
  DensityOracle(const MaterialSpec& spec, Sampler sampler);

  // At directions of any length above the horizon.
  [[nodiscard]] long double operator()(const densities::Vector& wi,
                                       const densities::Vector& wo) const;

 private:
  std::vector<LobeSpec> lobes_;  // those that are drawn for themselves
  Sampler sampler_;
  densities::Real rotation_;  // of the tangents, in degrees
};

}  // namespace gonio::testing
