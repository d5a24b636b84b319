// What a Material holds, for the engine only.
#pragma once

#include <memory>
#include <vector>

#include "engine/kernel.h"
#include "engine/material.h"

namespace gonio {

struct MaterialPart {
  // Of the two measured kernels or, for an analytic lobe, by index.
  enum class Source : std::uint8_t { analytic, measured_linear, measured_nearest };
  Source source = Source::analytic;
  std::size_t kernel = 0;
  std::shared_ptr<const void> constants;

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
};

}  // namespace gonio
