#include "client/cli/tool/known_names.h"

#include "gonio/engine/registry.h"

namespace gonio::cli {

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const ModelDescription& model : models()) names.emplace_back(model.name);
  return names;
}

std::vector<std::string> fitted_names() {
  std::vector<std::string> names{"all"};
  for (const ModelDescription& model : models()) {
    if (model.role == Role::measured) continue;
    names.emplace_back(model.name);
    for (const Parameter& parameter : model.parameters) {
      if (parameter.name != "fresnel") continue;
      for (const std::string_view word : parameter.words)
        names.push_back(std::string(model.name) + ":" + std::string(word));
    }
  }
  return names;
}

}  // namespace gonio::cli
