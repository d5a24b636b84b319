// The derivative of a material's reflectance by one of its parameters: what a fit climbs by.
//
// It is evaluated like a material, with the same directions, layouts and threads, in float64. At a
// clamp or another corner of a formula it is one-sided; it is finite there. Pairs that cannot be
// evaluated get 0 and their flag.
#pragma once

#include <string_view>

#include "gonio/engine/evaluate.h"
#include "gonio/engine/material.h"

namespace gonio {

class MaterialDerivative {
 public:
  // df/dp with p named as in errors: "parameters.s", "specular[1].parameters.f0", or "rotation" (by
  // the degree). By a colour,
  // channel c has the derivative of f_c by the colour's channel c (all other channels' are 0).
  // Errors are those of Material::create, or name what can be chosen as "by".
  static Result<MaterialDerivative> create(const MaterialSpec& spec, std::string_view by);

  [[nodiscard]] int channels() const { return material_.channels(); }

  // As of a Material; the values are derivatives.
  template <class In>
  std::uint8_t evaluate(const Batch<In, double>& batch, Isa isa) const {
    return gonio::evaluate(material_, batch, isa);
  }
  template <class In>
  std::uint8_t evaluate(const Batch<In, double>& batch, Isa isa, ThreadPool& pool) const {
    return gonio::evaluate(material_, batch, isa, pool);
  }

 private:
  explicit MaterialDerivative(Material material) : material_(std::move(material)) {}
  Material material_;  // for Precision::reference only
};

}  // namespace gonio
