// What a specification evaluates to.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "gonio/engine/evaluate.h"

namespace gonio {

// f at one pair of directions.
inline std::vector<double> value(const MaterialSpec& spec) {
  const auto material = Material::create(spec);
  EXPECT_TRUE(material.ok()) << material.error().message;
  const std::array<double, 3> wi{0.6, 0, 0.8}, wo{0, 0.28, 0.96};
  std::vector<double> f(static_cast<std::size_t>(material->channels()));
  evaluate(
      *material,
      Batch<double, double>{Directions<double>::interleaved(wi.data()),
                            Directions<double>::interleaved(wo.data()), 1,
                            Values<double>::interleaved(f.data(), material->channels()), nullptr},
      Isa::baseline);
  return f;
}

}  // namespace gonio
