#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "client/cli/commands.h"
#include "client/cli/exit_codes.h"
#include "client/cli/local_reference.h"
#include "client/cli/output_file.h"
#include "client/cli/progress.h"
#include "client/cli/scene_file.h"
#include "client/cli/select_report.h"
#include "server/materials.h"

namespace gonio::cli {
namespace {

constexpr const char* kFooter = R"(
The reference is a material (JSON, a .json file, or MERL's .binary), itself the last candidate, or a file
of measured pairs, as for 'gonio fit'. The scene is a JSON file of
  theta_i, theta_o   [lower, upper] degrees, of light and view; with an environment theta_i is [0, 90] if
                     not given
  phi                [lower, upper] between their azimuths, 0 to 180, where the mirror's side is
  histogram          in place of these: {"theta_i": edges, "theta_o": edges, "phi": edges, "counts":
                     numbers, phi the fastest}
  lights             "directional" (if not given) or "environment"
  anisotropy         false: only isotropic candidates
  tolerance, metric  of the error: "l1" (if not given), relative; "rmse", "log" or "cbrt"
  confidence         that the error is below the tolerance: 0.95 if not given
  cost               "ns" (if not given), "bytes" or "ns_variance": ns times 1 + variance / mean^2 of
                     samples, for environments
Every model is tried, alone, over a lambertian base and as two lobes over one. In the table o marks the
front, those that err less than all that cost less by more than chance, and * the choice: the cheapest
whose error is certified to be below the tolerance, on directions that it was neither fitted to nor
chosen by. Works in this process.

Exit status 1 if nothing is good enough.

Example, with scene.json {"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.1}:
  gonio select --reference nickel.binary --scene scene.json -o nickel.json)";

struct SelectArguments {
  std::string reference, scene, costs, output, report;
  bool degrees = false, all = false, quiet = false;
  select::Options options;
};

bool is_material(const std::string& argument) {
  const auto extension = std::filesystem::path(argument).extension();
  return argument.starts_with("{") || extension == ".json" || extension == ".binary";
}

Result<select::Selection> choose(const SelectArguments& arguments, const select::Scene& scene) {
  Materials materials;
  materials.allow_local_files();
  select::Options options = arguments.options;
  if (!arguments.costs.empty()) {
    auto costs = read_costs(arguments.costs);
    if (!costs) return costs.error();
    options.costs = std::move(*costs);
  }
  Progress progress(!arguments.quiet, "candidates");
  options.progress = [&](const std::string& name, std::size_t done, std::size_t of) {
    progress.show(static_cast<double>(done) / static_cast<double>(of), name);
  };
  if (is_material(arguments.reference)) {
    const auto material = local_material(materials, arguments.reference);
    if (!material) return material.error();
    return select::choose(*material, scene, options);
  }
  const auto data = local_data(materials, arguments.reference, arguments.degrees);
  if (!data) return data.error();
  return select::choose(*data, scene, options);
}

Outcome write(const std::string& file, const std::string& text) {
  if (file.empty()) return Ok{};
  auto output = OutputFile::open(file);
  if (!output) return output.error();
  if (auto written = output->write(text); !written) return written;
  return output->commit();
}

int run(const SelectArguments& arguments) {
  const auto scene = read_scene(arguments.scene);
  if (!scene) return fail(scene.error());
  const auto selection = choose(arguments, *scene);
  if (!selection) return fail(selection.error());
  const auto& choice = selection->choice;
  Outcome written = write(arguments.report, select_json(*selection));
  // The reference itself is not written: it is where it was.
  const bool analytic = choice && selection->entries[choice->entry].parameters > 0;
  if (written && analytic)
    written = write(arguments.output, material_json(choice->material) + "\n");
  if (!written) return fail(written.error());
  const bool taken = arguments.output == "-" || arguments.report == "-";
  if (!arguments.quiet)
    std::fputs(select_table(*selection, arguments.all).c_str(), taken ? stderr : stdout);
  return choice ? exit_ok : exit_failed;
}

void add_options(CLI::App& command, SelectArguments& arguments) {
  command.footer(kFooter);
  command.add_option("--reference", arguments.reference, "What is to be replaced (see below)")
      ->type_name("R")
      ->required();
  command.add_option("--scene", arguments.scene, "What the scene needs (see below)")
      ->type_name("FILE")
      ->required();
  command
      .add_option("--costs", arguments.costs,
                  "Nanoseconds by part, as JSON: {\"ggx:schlick\": 4.4, ...}; else measured here")
      ->type_name("FILE");
  command
      .add_option("--lobes", arguments.options.lobes,
                  "At most so many specular lobes: 1, or 2 if not given")
      ->type_name("N")
      ->check(CLI::Range(1, 2).description(""));
  command.add_option("--seed", arguments.options.seed, "Of the choice of pairs; 1 if not given")
      ->type_name("N");
  command.add_flag("--deg", arguments.degrees, "Angles of a CSV are in degrees");
  command.add_flag("--all", arguments.all, "Show what is not on the front, too, and why");
  command.add_option("-o,--output", arguments.output, "Where the choice's JSON goes; - is stdout")
      ->type_name("OUT");
  command.add_option("--report", arguments.report, "Where all that is known goes, as JSON")
      ->type_name("OUT");
  command.add_flag("--quiet,-q", arguments.quiet, "No progress bar and no table");
}

}  // namespace

Command add_select_command(CLI::App& app) {
  auto arguments = std::make_shared<SelectArguments>();
  CLI::App* command =
      app.add_subcommand("select", "The cheapest material that is good enough for a scene");
  add_options(*command, *arguments);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
