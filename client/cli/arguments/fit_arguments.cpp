#include "client/cli/arguments/fit_arguments.h"

#include <numbers>
#include <optional>
#include <utility>

#include "client/cli/output/numbers.h"
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

}  // namespace gonio::cli
