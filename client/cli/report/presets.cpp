#include "client/cli/report/presets.h"

#include <algorithm>

#include "base/text/join.h"
#include "client/cli/output/json.h"
#include "client/cli/output/numbers.h"
#include "client/cli/output/text.h"

namespace gonio::cli {
namespace {

bool same(const client::PresetInfo& a, const client::PresetInfo& b) {
  return a.name == b.name && a.values == b.values && a.source == b.source;
}

bool holds(const PresetList& list, const client::ParameterInfo& parameter) {
  return list.partner == parameter.preset_partner &&
         std::equal(list.presets.begin(), list.presets.end(), parameter.presets.begin(),
                    parameter.presets.end(), same);
}

void add(std::vector<PresetList>& lists, const client::ParameterInfo& parameter) {
  if (parameter.presets.empty()) return;
  const auto list = std::find_if(lists.begin(), lists.end(),
                                 [&](const PresetList& l) { return holds(l, parameter); });
  if (list == lists.end()) {
    lists.push_back({{parameter.name}, parameter.preset_partner, parameter.presets});
    return;
  }
  auto& names = list->parameters;
  if (std::find(names.begin(), names.end(), parameter.name) == names.end())
    names.push_back(parameter.name);
}

}  // namespace

std::vector<PresetList> preset_lists(const client::Catalogue& catalogue) {
  std::vector<PresetList> lists;
  for (const auto& model : catalogue.models) {
    for (const auto& parameter : model.parameters) add(lists, parameter);
  }
  return lists;
}

std::string preset_json(const client::Catalogue& catalogue) {
  std::string json = "{\"presets\": [";
  const char* separator = "\n";
  for (const PresetList& list : preset_lists(catalogue)) {
    std::vector<std::string> parameters;
    for (const std::string& name : list.parameters) parameters.push_back(json_string(name));
    for (const auto& preset : list.presets) {
      std::vector<std::string> values;
      for (const double value : preset.values) values.push_back(shortest(value));
      json += separator + ("{\"name\": " + json_string(preset.name)) + ", \"parameters\": [" +
              joined(parameters, ", ") + "], \"partner\": " + json_string(list.partner) +
              ", \"values\": [" + joined(values, ", ") +
              "], \"source\": " + json_string(preset.source) + "}";
      separator = ",\n";
    }
  }
  return json + "\n]}\n";
}

std::string preset_table(const client::Catalogue& catalogue) {
  const auto lists = preset_lists(catalogue);
  if (lists.empty()) return "No parameter has presets.\n";
  std::string text = padded("PARAMETER", 15) + padded("NAME", 11);
  for (const char* channel : {"RED", "GREEN", "BLUE"}) text += padded(channel, 8);
  text += "SOURCE\n";
  for (const PresetList& list : lists) {
    std::string parameters = joined(list.parameters, ", ");
    if (!list.partner.empty()) parameters += " (with " + list.partner + ")";
    for (const auto& preset : list.presets) {
      text += padded(parameters, 15) + padded(preset.name, 11);
      for (const double value : preset.values) text += padded(shortest(value), 8);
      text += preset.source + "\n";
    }
  }
  return text + "\nA name stands in the place of the numbers, as in \"" +
         lists.front().parameters.front() + "\": \"" + lists.front().presets.front().name +
         "\"; and in that of a material, as in --material " + lists.front().presets.front().name +
         ".\n";
}

}  // namespace gonio::cli
