#include "fit/report/substance.h"

#include <algorithm>
#include <cstdio>

#include "gonio/models/description.h"

namespace gonio::fit {
namespace {

const Parameter* find(std::span<const Parameter> parameters, std::string_view name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& p) { return p.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

// The word with which `p` has a meaning, where the lobe has another; none if it has that.
std::optional<std::string> missing_word(const FormLobe& lobe, const Parameter& p) {
  const auto& [parameter, words] = p.used_with;
  const auto chosen = lobe.held.parameters.find(parameter);
  if (words.empty() || chosen == lobe.held.parameters.end()) return {};
  const auto& word = std::get<std::string>(chosen->second);
  if (std::find(words.begin(), words.end(), word) != words.end()) return {};
  return std::string(words.front());
}

double largest_of(std::span<const Preset> presets) {
  double largest = 0;
  for (const Preset& preset : presets)
    largest = std::max(largest, *std::max_element(preset.rgb.begin(), preset.rgb.end()));
  return largest;
}

std::string sentence(const std::string& field, double value, double largest,
                     const std::string& instead) {
  char numbers[96];
  std::snprintf(numbers, sizeof numbers,
                " of %.4g is more than any known substance has (%.3g): ", value, largest);
  return field + numbers + "try " + instead;
}

}  // namespace

std::optional<std::string> substance_hint(const Form& form, const Certificate& report) {
  for (const ShapeParameter& shape : form.shapes) {
    const FormLobe& lobe = form.lobes[shape.lobe];
    const auto parameters = lobe.model->parameters;
    const Parameter* p = find(parameters, shape.names.front());
    // The rotation is a shape, but no parameter of a lobe's model.
    if (p == nullptr || p->presets.empty() || p->preset_partner.empty()) continue;
    const auto word = missing_word(lobe, *find(parameters, p->preset_partner));
    const auto fitted =
        std::find_if(report.parameters.begin(), report.parameters.end(),
                     [&](const ParameterReport& r) { return r.field == shape.field; });
    const double largest = largest_of(p->presets);
    if (!word || fitted == report.parameters.end() || fitted->value <= largest) continue;
    return sentence(shape.field, fitted->value, largest,
                    std::string(lobe.model->name) + ":" + *word);
  }
  return {};
}

}  // namespace gonio::fit
