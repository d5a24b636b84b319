#include "client/cli/report/model_page.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/text/join.h"
#include "client/cli/output/numbers.h"
#include "client/cli/output/summary.h"
#include "client/cli/output/text.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

std::string_view role_meaning(client::Role role) {
  switch (role) {
    case client::Role::diffuse:
      return "diffuse: stands alone, or as the diffuse base of a sum";
    case client::Role::specular:
      return "specular: stands alone, or as a specular lobe of a sum";
    case client::Role::measured:
      return "measured: a table, stands alone";
    case client::Role::unknown:
      break;
  }
  return "unknown to this version of gonio";
}

std::string value_text(const client::ParameterInfo& parameter) {
  if (!parameter.words.empty()) {
    return "one of " + joined(parameter.words, ", ") + "; default " + parameter.words.front();
  }
  if (parameter.file) return "the name of a file; always to be given";
  std::string text = parameter.colour ? "a number, or one per channel" : "a number";
  text += ", " + shortest(parameter.lower) + " to " + shortest(parameter.upper);
  if (parameter.unit == "rad") text += " radians";
  if (parameter.unit != "rad" && parameter.unit != "1") text += " " + parameter.unit;
  text += "; default " + shortest(parameter.start);
  if (!parameter.used_with.empty()) {
    text += "; with " + parameter.used_with + " " + joined(parameter.used_with_words, " or ");
  }
  if (!parameter.presets.empty()) {
    std::vector<std::string> names;
    for (const auto& preset : parameter.presets) names.push_back(preset.name);
    text += "; or one of " + joined(names, ", ");
    if (!parameter.preset_partner.empty())
      text += ", with " + parameter.preset_partner + " given too";
  }
  if (parameter.logarithmic) text += "; best varied on a logarithmic scale";
  return text;
}

// The word of `parameter.used_with` that an example takes: that of the first number that needs one.
std::string example_word(const client::ModelInfo& model, const std::string& choice) {
  for (const client::ParameterInfo& parameter : model.parameters) {
    if (parameter.used_with == choice) return parameter.used_with_words.front();
  }
  return {};
}

bool excluded(const client::ModelInfo& model, const client::ParameterInfo& parameter) {
  const auto& words = parameter.used_with_words;
  if (words.empty()) return false;
  const std::string word = example_word(model, parameter.used_with);
  return std::find(words.begin(), words.end(), word) == words.end();
}

// Every parameter at its default, but for those that exclude each other, of which it has the first;
// the word that chooses between them follows from that.
std::string example_json(const client::ModelInfo& model) {
  std::vector<std::string> parts;
  for (const client::ParameterInfo& parameter : model.parameters) {
    if (!example_word(model, parameter.name).empty()) continue;
    if (excluded(model, parameter)) continue;
    const std::string value =
        parameter.words.empty() ? shortest(parameter.start) : "\"" + parameter.words.front() + "\"";
    parts.push_back("\"" + parameter.name + "\": " + value);
  }
  return "{\"model\": \"" + model.name + "\", \"parameters\": {" + joined(parts, ", ") + "}}";
}

std::string example(const client::ModelInfo& model) {
  if (model.role == client::Role::measured) {
    return "  gonio evaluate --material FILE.binary --grid theta_i=30,theta_o=0:80:9 --deg\n";
  }
  const std::string json = example_json(model);
  return "  " + json + "\n\n  gonio evaluate --material '" + json +
         "' \\\n      --grid theta_i=30,theta_o=0:80:9 --deg\n";
}

}  // namespace

std::string_view role_word(client::Role role) {
  switch (role) {
    case client::Role::diffuse:
      return "diffuse";
    case client::Role::specular:
      return "specular";
    case client::Role::measured:
      return "measured";
    case client::Role::unknown:
      break;
  }
  return "unknown";
}

std::string model_table(const client::Catalogue& catalogue) {
  std::size_t width = 6;
  for (const auto& model : catalogue.models) width = std::max(width, model.name.size());
  std::string text = padded("MODEL", width + 2) + padded("ROLE", 10) + "WHAT IT IS\n";
  for (const auto& model : catalogue.models) {
    text +=
        padded(model.name, width + 2) + padded(role_word(model.role), 10) + model.summary + "\n";
    std::vector<std::string> names;
    for (const auto& parameter : model.parameters) names.push_back(parameter.name);
    const std::size_t indent = width + 12;
    text += std::string(indent, ' ') + wrapped(joined(names, ", "), indent) + "\n";
  }
  std::vector<std::string> sets;
  for (const auto set : catalogue.instruction_sets) sets.emplace_back(name_of(set));
  text += "\nStored materials: ";
  std::vector<std::string> materials;
  for (const auto& name : catalogue.materials) materials.push_back(shown(name));
  text += materials.empty() ? "none" : wrapped(joined(materials, ", "), 18);
  for (const auto& skipped : catalogue.skipped_materials) {
    text +=
        "\nNot served: " + wrapped(shown(skipped.name) + " (" + shown(skipped.reason) + ")", 12);
  }
  text += "\nInstruction sets: " + joined(sets, ", ");
  return text +
         "\n\n'gonio models NAME' describes one model, 'gonio models --presets' lists named "
         "values.\nBeside its models a material may have a \"rotation\" of the tangents u and v "
         "about "
         "the normal, in degrees.\n";
}

std::string model_page(const client::ModelInfo& model) {
  std::string text = model.name + ": " + wrapped(model.summary, model.name.size() + 2) + "\n\n";
  text += "Role       " + std::string(role_meaning(model.role)) + "\n";
  text += "Source     " + wrapped(model.source, 11) + "\n";
  text += "Fast       " + wrapped(bound_text(model.fast), 11) + "\n";
  text += "Reference  " + wrapped(bound_text(model.reference), 11) + "\n\nParameters\n";
  std::size_t width = 4;
  for (const auto& parameter : model.parameters) width = std::max(width, parameter.name.size());
  for (const auto& parameter : model.parameters) {
    const std::size_t indent = width + 4;
    text += "  " + padded(parameter.name, width + 2) + wrapped(parameter.meaning, indent) + "\n";
    text += std::string(indent, ' ') + wrapped(value_text(parameter), indent) + "\n";
  }
  if (model.parameters.empty()) text += "  none\n";
  return text + "\nExample\n" + example(model);
}

}  // namespace gonio::cli
