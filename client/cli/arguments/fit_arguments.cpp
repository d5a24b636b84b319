#include "client/cli/arguments/fit_arguments.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "base/near_names.h"
#include "client/cli/output/numbers.h"
#include "client/cli/output/text.h"
#include "client/cli/tool/known_names.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

constexpr const char* kFooter = R"(
Data: with --server, the name of a measured material that the server holds ('gonio put'); else a file. Its
content says what it is; where that leaves a doubt, its extension does:
  .binary         MERL's table of half and difference angles
  .brdf           Cornell's text: wavelengths, then theta_i phi_i theta_s phi_s and a value for each
  .dat, .alta     ALTA's text, with the parametrisation ISOTROPIC_TL_TV_PROJ_DPHI
  .bsdf           a file of the RGL material database: isotropic, RGB
  else NPY        float32 or float64, N x (6 + channels): wi, wo and the values
  or CSV          with the header wi_x,wi_y,wi_z,wo_x,wo_y,wo_z (or theta_i,phi_i,theta_o,phi_o) and
                  f_0,f_1,... in 1/sr without a cosine, such as 'gonio evaluate --with-input' writes;
                  a column `weight` says how many sr^2 of pairs of directions a row stands for
Without weights, measurements of a goniometer (8 and more wo for each wi) are weighed by the directions
that are nearest to each, others all the same. Entries that are not finite, not unit, below the
horizon or negative are left out and counted, and so are rows of a CSV whose `flags` are not 0: a
hole of a table (128) is no measurement.

A specular model is fitted as a lobe over a lambertian base, with the exact Fresnel term of a
dielectric if it takes one; NAME:none, NAME:schlick, NAME:dielectric and NAME:conductor choose. With
--base none one lobe is fitted alone: ashikhmin_shirley then has its own diffuse term, which it has
in no sum. With several models the one with the least objective goes to -o.

Verdicts: converged; bound-limited, where a bound of a parameter holds the optimum; ambiguous, where the
data cannot tell the parameters apart; failed. Errors, over all data: l1 is sum |f - m| cos / sum
m cos, rmse of f cos in 1/sr, log and cbrt the differences of log(1 + f cos) and of cube roots; each
for all pairs, for both angles up to 80 degrees, and for the rest.

Exit status 1 if every verdict is failed, 2 if no pair can be used; then nothing is written with -o.

Examples:
  gonio fit --data nickel.binary --model cook_torrance --max-theta 80 -o nickel.json
  gonio fit --data paint.brdf --model all --report report.json --report report.md)";

void add_what(CLI::App& command, FitArguments& arguments) {
  arguments::add_option(command, "--data", arguments.data, "The measurements (see below)")
      .type_name("FILE")
      .required();
  arguments::add_option(
      command, "--model", arguments.models,
      "What to fit, NAME or NAME:FRESNEL (see below), several apart by commas; or all")
      .type_name("NAME,...")
      .suggest(fitted_names())
      .delimiter(',')
      .required();
  arguments::add_option(command, "--lobes", arguments.lobes,
                        "Specular lobes of the model: 1 (the default) or 2")
      .type_name("N")
      .range(1, 2);
  arguments::add_option(command, "--base", arguments.base,
                        "Under the lobes: lambertian (the default), another diffuse model, or none")
      .type_name("NAME");
  arguments::add_flag(
      command, "--anisotropic", arguments.anisotropic,
      "Roughness or exponents along u and v each by themselves, u and v being turned "
      "about the normal where the data are");
  arguments::add_option(command, "--rotation", arguments.rotation,
                        "Hold u and v turned by this, -180 to 180 degrees; 0: as they are")
      .type_name("DEG");
  arguments::add_flag(command, "--deg", arguments.degrees, "Angles of a CSV are in degrees");
}

void add_how(CLI::App& command, FitArguments& arguments) {
  arguments::add_option(command, "--objective", arguments.objective,
                        "What is minimised: l1 (the default), l2, huber, log or cbrt")
      .type_name("O")
      .one_of({"l1", "l2", "huber", "log", "cbrt"});
  arguments::add_option(
      command, "--strategy", arguments.strategy,
      "auto (the default), or staged: that of Nielsen et al. 2014, from one guess")
      .type_name("S")
      .one_of({"auto", "staged"});
  arguments::add_option(
      command, "--max-theta", arguments.max_theta,
      "Fit pairs whose angles are both up to this, degrees; errors are of all data")
      .type_name("DEG");
  arguments::add_option(command, "--min-theta", arguments.min_theta,
                        "Fit pairs one of whose angles is above this")
      .type_name("DEG");
  arguments::add_option(command, "--starts", arguments.starts,
                        "Places to descend from, 1 to 100; 6 if not given")
      .type_name("N")
      .range(1, 100);
  arguments::add_option(command, "--seed", arguments.seed,
                        "Of the choice of pairs, 1 or more; 1 if not given")
      .type_name("N")
      .range(std::uint64_t{1}, std::uint64_t{1} << 62U);
  arguments::add_flag(command, "--polish", arguments.polish, "End with a descent on all pairs");
}

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

void add_fit_options(CLI::App& command, FitArguments& arguments) {
  arguments::set_footer(command, kFooter);
  add_what(command, arguments);
  add_how(command, arguments);
  arguments::add_option(command, "-o,--output", arguments.output,
                        "Where the material's JSON goes; - is stdout")
      .type_name("OUT");
  arguments::add_option(
      command, "--report", arguments.reports,
      "Where all that is known of the fits goes: JSON, or a page for people if OUT ends "
      "in .md; may be given for each")
      .type_name("OUT")
      .one_value_a_time();
  add_connection_options(command, arguments.connection);
  arguments::add_flag(command, "--quiet,-q", arguments.quiet, "No progress bar and no table");
}

Outcome check_angles(const FitArguments& arguments) {
  if (!(arguments.max_theta > 0 && arguments.max_theta <= 90))
    return bad_value("--max-theta", shortest(arguments.max_theta), "above 0, up to 90 degrees");
  if (!(arguments.min_theta >= 0 && arguments.min_theta < arguments.max_theta))
    return bad_value("--min-theta", shortest(arguments.min_theta),
                     "0 to below --max-theta, " + shortest(arguments.max_theta) + " degrees");
  return Ok{};
}

client::FitOptions fit_options(const FitArguments& arguments) {
  constexpr double kRadians = std::numbers::pi / 180;
  client::FitOptions options;
  options.objective = client::objective_of(arguments.objective).value();
  if (arguments.strategy == "staged") options.strategy = client::FitStrategy::staged;
  options.anisotropic = arguments.anisotropic;
  options.min_theta = arguments.min_theta * kRadians;
  options.max_theta = arguments.max_theta * kRadians;
  options.starts = arguments.starts;
  options.polish = arguments.polish;
  options.seed = arguments.seed;
  return options;
}

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
