#include "client/cli/tool/known_names.h"

#include <algorithm>

#include "fit/form.h"
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
    if (!is_fitted(model.name)) continue;
    names.emplace_back(model.name);
    const Parameter* choice = choice_in_fits(model.name);
    if (choice == nullptr) continue;
    for (const std::string_view word : choice->words)
      names.push_back(std::string(model.name) + ":" + std::string(word));
  }
  return names;
}

const Parameter* choice_in_fits(std::string_view model) {
  const auto known = find_model(model);
  if (!known) return nullptr;
  const auto& all = (*known)->parameters;
  const auto found =
      std::find_if(all.begin(), all.end(), [](const Parameter& p) { return !p.fit_word.empty(); });
  return found == all.end() ? nullptr : &*found;
}

bool is_fitted(std::string_view model) {
  if (!find_model(model)) return true;
  LobeSpec lobe{std::string(model), {}};
  if (const Parameter* choice = choice_in_fits(model); choice != nullptr)
    lobe.parameters[std::string(choice->name)] = std::string(choice->fit_word);
  return fit::make_form({lobe, {}, {}}, {}).ok();
}

const Parameter* file_parameter(std::string_view model) {
  const auto known = find_model(model);
  if (!known) return nullptr;
  const auto& all = (*known)->parameters;
  const auto found = std::find_if(all.begin(), all.end(),
                                  [](const Parameter& p) { return p.type == ParameterType::file; });
  return found == all.end() ? nullptr : &*found;
}

const ModelDescription& model_of_files() {
  const auto all = models();
  return *std::find_if(all.begin(), all.end(), [](const ModelDescription& model) {
    return file_parameter(model.name) != nullptr;
  });
}

}  // namespace gonio::cli
