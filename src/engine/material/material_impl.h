// What a Material holds, for the engine only.
#pragma once

#include <memory>
#include <vector>

#include "engine/material/lobe_check.h"
#include "gonio/engine/material.h"
#include "kernels/part.h"

namespace gonio {

struct Material::Impl {
  int channels = 1;
  std::vector<Part> parts;  // at least one; the values add up
  ErrorBound fast, reference;
  std::size_t bytes = 0;
  double rotation = 0;  // of the tangents, in degrees

  // Adds a part with its bounds and its memory.
  void add(Part part);
};

// The cells of a material that is one table of measurements; null for all others.
std::shared_ptr<const MeasuredTable> table_of(const Material& material);

// The checked lobes of a specification, in order: the diffuse base first.
struct CheckedMaterial {
  std::vector<NamedLobe> named;
  std::vector<CheckedLobe> lobes;
  int channels = 1;
  double rotation = 0;
};
Result<CheckedMaterial> check_material(const MaterialSpec& spec, std::string_view prefix);

}  // namespace gonio
