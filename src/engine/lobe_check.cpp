#include "engine/lobe_check.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/registry.h"
#include "parts/fresnel.h"

namespace gonio {
namespace {

std::string text_of(double number) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), number).ptr;
  return {buffer, end};
}

std::string joined(std::span<const std::string_view> words) {
  std::string all;
  for (const std::string_view word : words) all += (all.empty() ? "" : ", ") + std::string(word);
  return all;
}

std::string parameter_names(const ModelDescription& model) {
  std::string all;
  for (const Parameter& p : model.parameters)
    all += (all.empty() ? "" : ", ") + std::string(p.name);
  return all.empty() ? "no parameters" : all;
}

const ParameterValue* find(const LobeSpec& lobe, std::string_view name) {
  const auto found = lobe.parameters.find(name);
  return found == lobe.parameters.end() ? nullptr : &found->second;
}

Outcome check_names(const ModelDescription& model, const NamedLobe& lobe) {
  for (const auto& [name, value] : lobe.spec->parameters) {
    const auto known = [&name = name](const Parameter& p) { return p.name == name; };
    if (std::none_of(model.parameters.begin(), model.parameters.end(), known)) {
      return bad_value(lobe.prefix + "parameters." + name,
                       "not a parameter of " + std::string(model.name), parameter_names(model));
    }
  }
  return Ok{};
}

Outcome check_length(const std::string& field, const Parameter& p, std::size_t length,
                     ChannelCount& channels) {
  const auto count = static_cast<std::size_t>(channels.count);
  if (length == 1) return Ok{};
  const std::string given = std::to_string(length) + " numbers";
  if (p.kind != Kind::colour) return bad_value(field, given, "one number");
  if (length == 0) return bad_value(field, "empty", "one number, or one per channel");
  if (length > static_cast<std::size_t>(kMaxChannels)) {
    return bad_value(field, given, "at most " + std::to_string(kMaxChannels) + " channels");
  }
  if (count != 1 && length != count) {
    return bad_value(field, given,
                     "1 or " + std::to_string(count) + ", as " + channels.set_by + " has");
  }
  channels = {static_cast<int>(length), field};
  return Ok{};
}

Result<std::vector<double>> check_numbers(const std::string& field, const Parameter& p,
                                          const ParameterValue& given, ChannelCount& channels) {
  const auto* numbers = std::get_if<std::vector<double>>(&given);
  const std::string bounds = "[" + text_of(p.lower) + ", " + text_of(p.upper) + "]";
  if (numbers == nullptr)
    return bad_value(field, '"' + std::get<std::string>(given) + '"', "a number in " + bounds);
  if (Outcome length = check_length(field, p, numbers->size(), channels); !length)
    return length.error();
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    const double number = (*numbers)[i];
    if (number >= p.lower && number <= p.upper) continue;  // false for NaN
    return bad_value(numbers->size() == 1 ? field : field + "[" + std::to_string(i) + "]",
                     text_of(number), bounds);
  }
  return *numbers;
}

// The place of a word among those allowed.
Result<std::size_t> check_word(const std::string& field, const Parameter& p,
                               const ParameterValue& given) {
  const auto* word = std::get_if<std::string>(&given);
  if (word == nullptr) return bad_value(field, "a number", joined(p.words));
  const auto found = std::find(p.words.begin(), p.words.end(), *word);
  if (found == p.words.end()) return bad_value(field, '"' + *word + '"', joined(p.words));
  return static_cast<std::size_t>(found - p.words.begin());
}

// Which of Fresnel's kinds the given numbers mean when no word says so.
std::string inferred_fresnel(const LobeSpec& lobe) {
  if (find(lobe, "f0") != nullptr) return "schlick";
  if (find(lobe, "k") != nullptr) return "conductor";
  return find(lobe, "eta") != nullptr ? "dielectric" : "none";
}

// A number that the chosen kind would ignore is a mistake, not a wish.
Outcome check_fresnel_use(const NamedLobe& lobe, std::string_view kind) {
  const auto refuse = [&](std::string_view name, std::string_view users) -> Outcome {
    return bad_value(lobe.prefix + "parameters." + std::string(name),
                     "given with fresnel " + std::string(kind),
                     "only with fresnel " + std::string(users));
  };
  if (find(*lobe.spec, "f0") != nullptr && kind != "schlick") return refuse("f0", "schlick");
  if (find(*lobe.spec, "k") != nullptr && kind != "conductor") return refuse("k", "conductor");
  if (find(*lobe.spec, "eta") != nullptr && kind != "dielectric" && kind != "conductor") {
    return refuse("eta", "dielectric or conductor");
  }
  return Ok{};
}

Outcome check_parameter(const NamedLobe& lobe, const Parameter& p, CheckedLobe& checked,
                        ChannelCount& channels) {
  const std::string field = lobe.prefix + "parameters." + std::string(p.name);
  const ParameterValue* given = find(*lobe.spec, p.name);
  if (p.kind != Kind::word) {
    if (given == nullptr) return checked.values.set(p.name, {p.start}), Ok{};
    Result<std::vector<double>> numbers = check_numbers(field, p, *given, channels);
    if (!numbers) return numbers.error();
    return checked.values.set(p.name, std::move(numbers).value()), Ok{};
  }
  std::size_t word = 0;
  const ParameterValue inferred = inferred_fresnel(*lobe.spec);
  if (given == nullptr && p.name == fresnel::kKind.name) given = &inferred;
  if (given != nullptr) {
    Result<std::size_t> found = check_word(field, p, *given);
    if (!found) return found.error();
    word = *found;
  }
  checked.kind = checked.kind * p.words.size() + word;
  return p.name == fresnel::kKind.name ? check_fresnel_use(lobe, p.words[word]) : Outcome(Ok{});
}

}  // namespace

Result<CheckedLobe> check_lobe(const NamedLobe& lobe, ChannelCount& channels) {
  Result<const ModelDescription*> model = find_model(lobe.spec->model);
  if (!model) {
    Error error = std::move(model).error();
    return bad_value(lobe.prefix + "model", error.value, error.allowed, error.code);
  }
  const Role role = (*model)->role;
  if (role == Role::measured) {
    return bad_value(lobe.prefix + "model", "\"measured\"",
                     "an analytic model; a measured one is stored under a name");
  }
  if (lobe.must_be && *lobe.must_be != role) {
    return bad_value(lobe.prefix + "model", '"' + lobe.spec->model + '"',
                     *lobe.must_be == Role::diffuse ? "a diffuse model" : "a specular model");
  }
  if (Outcome names = check_names(**model, lobe); !names) return names.error();
  CheckedLobe checked{*model, 0, {}};
  for (const Parameter& p : (*model)->parameters) {
    if (Outcome outcome = check_parameter(lobe, p, checked, channels); !outcome)
      return outcome.error();
  }
  return checked;
}

}  // namespace gonio
