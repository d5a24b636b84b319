#include "engine/material/lobe_check.h"

#include <algorithm>

#include "base/near_names.h"
#include "gonio/engine/registry.h"

namespace gonio {
namespace {

std::string joined(std::span<const std::string_view> words, std::string_view separator = ", ") {
  std::string all;
  for (const std::string_view word : words) {
    if (!all.empty()) all += separator;
    all += word;
  }
  return all;
}

std::vector<std::string_view> parameter_names(const ModelDescription& model) {
  std::vector<std::string_view> names;
  for (const Parameter& p : model.parameters) names.push_back(p.name);
  return names;
}

const ParameterValue* find(const LobeSpec& lobe, std::string_view name) {
  const auto found = lobe.parameters.find(name);
  return found == lobe.parameters.end() ? nullptr : &found->second;
}

Outcome check_names(const ModelDescription& model, const NamedLobe& lobe) {
  const std::vector<std::string_view> known = parameter_names(model);
  for (const auto& [name, value] : lobe.spec->parameters) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    return bad_value(lobe.prefix + "parameters." + name,
                     "not a parameter of " + std::string(model.name),
                     known.empty() ? "no parameters" : joined(known) + did_you_mean(name, known));
  }
  return Ok{};
}

// The place of a word among those allowed.
Result<std::size_t> check_word(const std::string& field, const Parameter& p,
                               const ParameterValue& given) {
  const auto* word = std::get_if<std::string>(&given);
  if (word == nullptr) return bad_value(field, "a number", joined(p.words));
  const auto found = std::find(p.words.begin(), p.words.end(), *word);
  if (found == p.words.end()) return unknown_word(field, *word, p.words);
  return static_cast<std::size_t>(found - p.words.begin());
}

bool usable_with(const Parameter& number, std::string_view word) {
  return has_word(number.used_with, word);
}

// The given numbers that have a meaning only with some words of `choice`.
std::vector<const Parameter*> given_users(const NamedLobe& lobe, const ModelDescription& model,
                                          const Parameter& choice) {
  std::vector<const Parameter*> users;
  for (const Parameter& p : model.parameters) {
    if (p.used_with.parameter == choice.name && find(*lobe.spec, p.name) != nullptr)
      users.push_back(&p);
  }
  return users;
}

// The word that the given numbers mean when none says so: the first that all can be used with. If
// they contradict each other, the first one's.
std::size_t inferred_word(const Parameter& choice, const std::vector<const Parameter*>& users) {
  for (std::size_t word = 0; word < choice.words.size(); ++word) {
    const auto fits = [&](const Parameter* p) { return usable_with(*p, choice.words[word]); };
    if (std::all_of(users.begin(), users.end(), fits)) return word;
  }
  const auto of_first =
      std::find(choice.words.begin(), choice.words.end(), users.front()->used_with.words.front());
  return static_cast<std::size_t>(of_first - choice.words.begin());
}

// A number that the chosen word would ignore is a mistake, not a wish.
Outcome check_use(const NamedLobe& lobe, const std::vector<const Parameter*>& users,
                  std::string_view word) {
  for (const Parameter* p : users) {
    if (usable_with(*p, word)) continue;
    const std::string choice(p->used_with.parameter);
    return bad_value(lobe.prefix + "parameters." + std::string(p->name),
                     "given with " + choice + " " + std::string(word),
                     "only with " + choice + " " + joined(p->used_with.words, " or "));
  }
  return Ok{};
}

Outcome check_choice(const NamedLobe& lobe, const Parameter& p, CheckedLobe& checked) {
  const auto users = given_users(lobe, *checked.model, p);
  std::size_t word = 0;
  if (const ParameterValue* given = find(*lobe.spec, p.name); given != nullptr) {
    Result<std::size_t> found =
        check_word(lobe.prefix + "parameters." + std::string(p.name), p, *given);
    if (!found) return found.error();
    word = *found;
  } else {
    word = inferred_word(p, users);
  }
  checked.kind = checked.kind * p.words.size() + word;
  return check_use(lobe, users, p.words[word]);
}

// What the preset of `p` needs beside it.
Outcome check_partner(const NamedLobe& lobe, const Parameter& p, const ParameterValue& given) {
  const auto* preset = std::get_if<std::string>(&given);
  if (preset == nullptr || p.preset_partner.empty()) return Ok{};
  if (find(*lobe.spec, p.preset_partner) != nullptr) return Ok{};
  return bad_value(lobe.prefix + "parameters." + std::string(p.preset_partner), "not given",
                   '"' + *preset + "\", as for " + std::string(p.name) + ", or numbers");
}

// What a word may have meant that is no preset of `p`: one that other parameters of the model have,
// as metals stand for eta and k and not for f0, or one that is written like it.
std::string preset_hint(const ModelDescription& model, const Parameter& p,
                        const std::string& word) {
  std::vector<std::string_view> holders, names;
  for (const Preset& preset : p.presets) names.push_back(preset.name);
  for (const Parameter& other : model.parameters) {
    for (const Preset& preset : other.presets) {
      if (preset.name == word) holders.push_back(other.name);
      if (std::find(names.begin(), names.end(), preset.name) == names.end())
        names.push_back(preset.name);
    }
  }
  if (holders.empty()) return did_you_mean(word, names);
  std::string given;
  for (const std::string_view holder : holders) {
    given += (given.empty() ? "\"" : ", \"") + std::string(holder) + "\": \"" + word + "\"";
  }
  return "; " + word + " is known by " + joined(holders, " and ") + ": " + given;
}

Result<std::vector<double>> numbers_of(const NamedLobe& lobe, const ModelDescription& model,
                                       const Parameter& p, const ParameterValue& given,
                                       ChannelCount& channels) {
  const std::string field = lobe.prefix + "parameters." + std::string(p.name);
  auto numbers = check_numbers(field, p, given, channels);
  const auto* word = std::get_if<std::string>(&given);
  if (numbers || word == nullptr) return numbers;
  const Error& error = numbers.error();
  return bad_value(error.field, error.value, error.allowed + preset_hint(model, p, *word));
}

Outcome check_file(const NamedLobe& lobe, const Parameter& p, CheckedLobe& checked) {
  const ParameterValue* given = find(*lobe.spec, p.name);
  const auto* name = given == nullptr ? nullptr : std::get_if<std::string>(given);
  if (name == nullptr || name->empty()) {
    return bad_value(lobe.prefix + "parameters." + std::string(p.name),
                     given == nullptr || name != nullptr ? "not given" : "a number",
                     "the name of " + std::string(p.meaning));
  }
  return checked.file = *name, Ok{};
}

Outcome check_parameter(const NamedLobe& lobe, const Parameter& p, CheckedLobe& checked,
                        ChannelCount& channels) {
  if (p.type == ParameterType::word) return check_choice(lobe, p, checked);
  if (p.type == ParameterType::file) return check_file(lobe, p, checked);
  const ParameterValue* given = find(*lobe.spec, p.name);
  if (given == nullptr) return checked.values.set(p.name, {p.start}), Ok{};
  Result<std::vector<double>> numbers = numbers_of(lobe, *checked.model, p, *given, channels);
  if (!numbers) return numbers.error();
  if (Outcome partner = check_partner(lobe, p, *given); !partner) return partner;
  return checked.values.set(p.name, std::move(numbers).value()), Ok{};
}

Result<CheckedLobe> check_parameters(const ModelDescription& model, const NamedLobe& lobe,
                                     ChannelCount& channels) {
  if (Outcome names = check_names(model, lobe); !names) return names.error();
  CheckedLobe checked{&model, 0, {}};
  for (const Parameter& p : model.parameters) {
    if (Outcome outcome = check_parameter(lobe, p, checked, channels); !outcome)
      return outcome.error();
  }
  return checked;
}

Result<const ModelDescription*> model_of(const NamedLobe& lobe) {
  Result<const ModelDescription*> model = find_model(lobe.spec->model);
  if (model) return model;
  Error error = std::move(model).error();
  return bad_value(lobe.prefix + "model", error.value, error.allowed, error.code);
}

}  // namespace

Result<CheckedLobe> check_lobe(const NamedLobe& lobe, ChannelCount& channels) {
  const Result<const ModelDescription*> model = model_of(lobe);
  if (!model) return model.error();
  const Role role = (*model)->role;
  if (role == Role::measured) {
    return bad_value(lobe.prefix + "model", '"' + lobe.spec->model + '"',
                     "an analytic model; a measured one is stored under a name");
  }
  if (lobe.must_be && *lobe.must_be != role) {
    return bad_value(lobe.prefix + "model", '"' + lobe.spec->model + '"',
                     *lobe.must_be == Role::diffuse ? "a diffuse model" : "a specular model");
  }
  return check_parameters(**model, lobe, channels);
}

Result<CheckedLobe> check_measured(const NamedLobe& lobe) {
  const Result<const ModelDescription*> model = model_of(lobe);
  if (!model) return model.error();
  if ((*model)->role != Role::measured) {
    return bad_value(lobe.prefix + "model", '"' + lobe.spec->model + '"', "a measured model");
  }
  ChannelCount channels;
  return check_parameters(**model, lobe, channels);
}

}  // namespace gonio
