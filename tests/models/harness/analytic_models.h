// The names of the registry's analytic models, which tests loop over.
#pragma once

#include <string>
#include <vector>

#include "gonio/engine/registry.h"

namespace gonio::testing {

inline std::vector<std::string> analytic_models() {
  std::vector<std::string> names;
  for (const ModelDescription& model : models()) {
    if (model.role != Role::measured) names.emplace_back(model.name);
  }
  return names;
}

}  // namespace gonio::testing
