// What a Material holds, for the engine only.
#pragma once

#include <memory>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/material/lobe_check.h"
#include "gonio/engine/material.h"

namespace gonio {

struct MaterialPart {
  // One of the two measured kernels or, for an analytic lobe and its derivative, by index.
  enum class Source : std::uint8_t { analytic, derivative, measured_linear, measured_nearest };
  Source source = Source::analytic;
  std::size_t kernel = 0;
  std::shared_ptr<const void> constants;
  // What the constants were made of; null for tables and derivatives.
  std::shared_ptr<const CheckedLobe> lobe = {};

  // Not for derivatives, which have kernels of their own.
  [[nodiscard]] const KernelSet& kernels(const KernelTable& table) const {
    if (source == Source::analytic) return table.analytic[kernel];
    return source == Source::measured_linear ? table.measured_linear : table.measured_nearest;
  }
};

struct Material::Impl {
  int channels = 1;
  std::vector<MaterialPart> parts;  // at least one; the values add up
  ErrorBound fast, reference;
  std::size_t bytes = 0;
  std::shared_ptr<const MeasuredTable> table;  // of a measured material, else null
  double rotation = 0;                         // of the tangents, in degrees
};

// The checked lobes of a specification, in order: the diffuse base first.
struct CheckedMaterial {
  std::vector<NamedLobe> named;
  std::vector<CheckedLobe> lobes;
  int channels = 1;
  double rotation = 0;
};
Result<CheckedMaterial> check_material(const MaterialSpec& spec, std::string_view prefix);

}  // namespace gonio
