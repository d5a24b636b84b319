#include "client/cli/arguments/select_arguments.h"

#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

constexpr const char* kFooter = R"(
The reference is a material (JSON, a .json file, MERL's .binary, or the name of one that the server
holds), itself the last candidate, or a file of measured pairs, as for 'gonio fit'. The scene is a JSON
file of
  theta_i, theta_o   [lower, upper] degrees, of light and view; with an environment theta_i is [0, 90] if
                     not given
  phi                [lower, upper] between their azimuths, 0 to 180, where the mirror's side is
  histogram          in place of these: {"theta_i": edges, "theta_o": edges, "phi": edges, "counts":
                     numbers, phi the fastest}
  lights             "directional" (if not given) or "environment"
  anisotropy, time   whether they matter; anisotropy false: only isotropic candidates; time true: none
                     varies with time, and it is refused
  tolerance, metric  of the error: "l1" (if not given), relative; "rmse", "log", "cbrt", or "delta_e":
                     CIEDE2000, the mean over the picture of a sphere, of which about 1 is just seen
  confidence         that the error is below the tolerance: 0.95 if not given
  cost               "ns" (if not given), "bytes" or "ns_variance": ns times 1 + variance / mean^2 of
                     samples, for environments
  materials          in place of --reference: {NAME: {"reference": ...}, ...}, each with fields of its own
                     in place of those above; files are looked for beside the scene's
Every model is tried, alone, over a lambertian base and as two lobes over one. In the table o marks the
front, those that err less than all that cost less by more than chance, and * the choice: the cheapest
whose error is certified to be below the tolerance, on directions that it was neither fitted to nor
chosen by. Of several materials there is a line for each, with what it costs before and after.

Exit status 4 if nothing is good enough.

Examples, with scene.json {"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.1}, and with
"materials": {"car": {"reference": "car.binary"}, ...} in it:
  gonio select --reference nickel.binary --scene scene.json -o nickel.json
  gonio select --scene scene.json -o cheaper/)";

}  // namespace

void add_select_options(CLI::App& command, SelectArguments& arguments) {
  arguments::set_footer(command, kFooter);
  arguments::add_option(command, "--scene", arguments.scene, "What the scene needs (see below)")
      .type_name("FILE")
      .required();
  arguments::add_option(command, "--reference", arguments.reference,
                        "What is to be replaced (see below), if the scene does not name it")
      .type_name("R");
  arguments::add_option(command, "--costs", arguments.costs,
                        "Nanoseconds by part, as JSON: {\"ggx:schlick\": 4.4, ...}; else measured")
      .type_name("FILE");
  arguments::add_option(command, "--lobes", arguments.options.lobes,
                        "At most so many specular lobes: 1, or 2 if not given")
      .type_name("N")
      .range(1, 2);
  arguments::add_option(command, "--seed", arguments.options.seed,
                        "Of the choice of pairs, 1 or more; 1 if not given")
      .type_name("N")
      .range(std::uint64_t{1}, std::uint64_t{1} << 62U);
  arguments::add_flag(command, "--no-front", arguments.no_front,
                      "Stop at the choice: do not look at what costs more");
  arguments::add_flag(command, "--deg", arguments.degrees, "Angles of a CSV are in degrees");
  arguments::add_flag(command, "--all", arguments.all,
                      "Show what is not on the front, too, and why");
  arguments::add_option(
      command, "-o,--output", arguments.output,
      "Where the choice's JSON goes, - is stdout; a folder of NAME.json for a scene that "
      "names its materials. Nothing is written where that is the reference or nothing")
      .type_name("OUT");
  arguments::add_option(command, "--report", arguments.report,
                        "Where all that is known goes, as JSON; - is stdout")
      .type_name("OUT");
  add_connection_options(command, arguments.connection);
  arguments::add_flag(command, "--quiet,-q", arguments.quiet, "No progress bar and no table");
}

}  // namespace gonio::cli
