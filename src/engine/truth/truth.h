// What a material's reflectance is, in long double: the truth that errors are measured against.
//
// It is the models' own templates over another number system (numeric/extended.h), so it shows what
// rounding, short series and quick divisions make of a formula, not whether the formula is right;
// tests hold it to an oracle that shares nothing with it. Some 0.2 us a pair, lobe and channel.
// Thread safety: immutable.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "gonio/engine/material.h"
#include "kernels/part.h"

namespace gonio {

class Truth {
 public:
  using Direction = std::array<double, 3>;

  explicit Truth(const Material& material);

  // The material with each of the parameters that its error bounds name for where a difference
  // crosses 0 (ModelDescription::crossing) made larger and smaller by `relative`. Empty for most.
  static std::vector<Truth> of_roundings(const Material& material, double relative);

  [[nodiscard]] int channels() const { return channels_; }

  // f in 1/sr of every channel, as evaluate() defines it for directions of any length within its
  // tolerance; 0 for a pair that cannot be evaluated. `scale`, if not empty, is what the relative
  // error bounds are relative to: f; of a measured table the largest of the cells that are
  // interpolated, and NaN where rounding decides which these are.
  void evaluate(const Direction& wi, const Direction& wo, std::span<long double> f,
                std::span<long double> scale = {}) const;

 private:
  int channels_;
  std::vector<PartTruth> parts_;
};

}  // namespace gonio
