#include "client/cli/arguments/fit_forms.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "base/near_names.h"
#include "base/text/join.h"
#include "client/cli/tool/known_names.h"

namespace gonio::cli {
namespace {

// "NAME:WORD" taken apart.
struct Wanted {
  std::string name, word;
};

Wanted take_apart(const std::string& argument) {
  const std::size_t colon = argument.find(':');
  if (colon == std::string::npos) return {argument, {}};
  return {argument.substr(0, colon), argument.substr(colon + 1)};
}

// Of the server's model, what a word after its name chooses; null if nothing.
const client::ParameterInfo* choice_of(const client::ModelInfo& model) {
  const Parameter* choice = choice_in_fits(model.name);
  for (const auto& parameter : model.parameters) {
    if (choice != nullptr && parameter.name == choice->name) return &parameter;
  }
  return nullptr;
}

// One lobe without a base is a model by itself.
client::Material over(const std::string& base, const client::Lobe& lobe, int lobes) {
  if (base == "none" && lobes == 1) return client::Material::model(lobe.model, lobe.parameters);
  std::optional<client::Lobe> diffuse;
  if (base != "none") diffuse = client::Lobe{base, {}};
  return client::Material::sum(diffuse, std::vector(static_cast<std::size_t>(lobes), lobe));
}

std::string near_word(const std::string& word, const std::vector<std::string>& words) {
  return did_you_mean(word, std::span<const std::string>(words));
}

// What stands under the lobes: as given, else the first diffuse model that is one number.
Result<std::string> base_of(const FitArguments& arguments, const client::Catalogue& catalogue) {
  constexpr const char* kNone = "none";
  std::vector<std::string> allowed;
  std::string plainest = kNone;
  for (const auto& model : catalogue.models) {
    if (model.role != client::Role::diffuse) continue;
    allowed.push_back(model.name);
    if (plainest == kNone && model.parameters.size() == 1) plainest = model.name;
  }
  allowed.emplace_back(kNone);
  const std::string base = arguments.base.value_or(plainest);
  if (std::find(allowed.begin(), allowed.end(), base) != allowed.end()) return base;
  return unknown_word("--base", base, std::span<const std::string>(allowed));
}

// A lobe with the word that is wanted, or else with that of its table.
Result<client::Lobe> lobe_of(const client::ModelInfo& model, const std::string& wanted) {
  const client::ParameterInfo* choice = choice_of(model);
  if (choice == nullptr && wanted.empty()) return client::Lobe{model.name, {}};
  const std::string word =
      wanted.empty() ? std::string(choice_in_fits(model.name)->fit_word) : wanted;
  const std::string given = "\"" + model.name + ":" + word + "\"";
  if (choice == nullptr)
    return bad_value("--model", given, model.name + ", which takes no Fresnel term");
  const auto& words = choice->words;
  if (std::find(words.begin(), words.end(), word) == words.end())
    return bad_value("--model", given, joined(words, ", ") + near_word(word, words));
  return client::Lobe{model.name, {{choice->name, word}}};
}

Result<FitForm> form_of(const client::ModelInfo& model, const std::string& wanted,
                        const std::string& base, const FitArguments& arguments) {
  const auto lobe = lobe_of(model, wanted);
  if (!lobe) return lobe.error();
  const std::string name = wanted.empty() ? model.name : model.name + ":" + wanted;
  client::Material form = model.role == client::Role::diffuse ? client::Material::model(model.name)
                                                              : over(base, *lobe, arguments.lobes);
  return FitForm{name, arguments.rotation ? form.rotated(*arguments.rotation) : std::move(form)};
}

bool can_be_fitted(const client::ModelInfo& model) {
  const bool analytic = model.role == client::Role::diffuse || model.role == client::Role::specular;
  return analytic && is_fitted(model.name);
}

}  // namespace

Result<std::vector<FitForm>> fit_forms(const FitArguments& arguments,
                                       const client::Catalogue& catalogue) {
  const auto base = base_of(arguments, catalogue);
  if (!base) return base.error();
  std::vector<FitForm> forms;
  std::vector<std::string> names;
  for (const auto& model : catalogue.models) {
    if (can_be_fitted(model)) names.push_back(model.name);
  }
  std::vector<std::string> wanted;
  for (const std::string& argument : arguments.models) {
    if (argument == "all") wanted.insert(wanted.end(), names.begin(), names.end());
    if (argument != "all") wanted.push_back(argument);
  }
  for (const std::string& argument : wanted) {
    const Wanted parts = take_apart(argument);
    const std::string& name = parts.name;
    const auto model =
        std::find_if(catalogue.models.begin(), catalogue.models.end(),
                     [&](const auto& m) { return m.name == name && can_be_fitted(m); });
    if (model == catalogue.models.end())
      return bad_value("--model", "\"" + name + "\"",
                       "all, " + joined(names, ", ") + near_word(name, names));
    auto form = form_of(*model, parts.word, *base, arguments);
    if (!form) return form.error();
    forms.push_back(std::move(*form));
  }
  return forms;
}

}  // namespace gonio::cli
