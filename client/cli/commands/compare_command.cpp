#include <memory>
#include <utility>

#include "client/cli/commands/commands.h"
#include "client/cli/compare/compare_pictures.h"
#include "client/cli/compare/comparison.h"
#include "client/cli/compare/report.h"
#include "client/cli/connection/connection.h"
#include "client/cli/input/file_kind.h"
#include "client/cli/output/check_outputs.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/output_file.h"
#include "client/picture/lobe/slices.h"
#include "server/arguments/options.h"
#include "server/materials/preset_material.h"

namespace gonio::cli {
namespace {

constexpr const char* kFooter = R"(
The reference is a file of measurements, as for 'gonio fit'. Errors: L1 is sum |f - m| cos / sum m cos, RMSE
of f cos in 1/sr, LOG and CBRT the differences of log(1 + f cos) and of cube roots; each for all pairs,
for both angles up to 80 degrees, and for the rest. Below each material: what is measured and what the
material reflects within 25 degrees of the mirror direction, so near to the light, and elsewhere, as
parts of all that is measured. Works in this process.

Pictures: --slices draws the measurements in the plane of incidence as dots and the materials as lines, at 30, 60
and 80 degrees, or what is measured within 5 degrees of them. --render draws a sphere of what is measured
(a MERL .binary: scattered pairs cannot be evaluated) beside one of each material, in two lights.

Examples:
  gonio compare --reference nickel.binary --material cook_torrance.json ggx.json
  gonio compare --reference nickel.binary --material ggx.json --slices slices.png --render spheres.png)";

constexpr std::size_t kMostSpheres = 7;

struct CompareArguments {
  std::string reference;
  std::vector<std::string> materials;
  bool degrees = false;
  std::string slices, render, report;  // empty: none
};

Outcome check_picture(const std::string& option, const std::string& file, std::size_t materials,
                      std::size_t most) {
  if (file.empty()) return Ok{};
  if (extension_of(file) != ".png")
    return bad_value(option, "\"" + file + "\"", "a file that ends in .png");
  if (materials <= most) return Ok{};
  return bad_value("--material", std::to_string(materials) + " materials, with " + option,
                   "1 to " + std::to_string(most));
}

Outcome check(const CompareArguments& arguments) {
  const std::size_t materials = arguments.materials.size();
  auto good = check_picture("--slices", arguments.slices, materials, lobe::kMostLines);
  if (good) good = check_picture("--render", arguments.render, materials, kMostSpheres);
  if (!good) return good;
  std::vector<NamedFile> inputs{{"--reference", arguments.reference}};
  for (const std::string& material : arguments.materials)
    inputs.push_back({"--material", material});
  if (auto apart = check_standard_input(inputs); !apart) return apart;
  if (auto apart = check_outputs({{"--slices", arguments.slices},
                                  {"--render", arguments.render},
                                  {"--report", arguments.report}},
                                 inputs);
      !apart)
    return apart;
  return check_extension({"--report", arguments.report}, {".json"});
}

Outcome write(const std::string& file, const Result<std::string>& content) {
  if (!content) return content.error();
  auto output = OutputFile::open(file);
  if (!output) return output.error();
  return output->write_whole(*content);
}

Outcome draw_spheres(const CompareArguments& arguments, const Comparison& comparison) {
  if (!comparison.input.measured) {
    return bad_value("--reference", "\"" + arguments.reference + "\", with --render",
                     "a MERL .binary: scattered measurements cannot be evaluated between them");
  }
  auto connection = Connection::open({});
  if (!connection) return connection.error();
  return write(arguments.render, spheres_png(shown_name(arguments.reference), connection->client,
                                             *comparison.input.measured, comparison.compared));
}

// The pictures that are asked for.
Outcome draw(const CompareArguments& arguments, const Comparison& comparison) {
  Outcome drawn = Ok{};
  if (!arguments.slices.empty()) {
    drawn = write(arguments.slices, slices_png(shown_name(arguments.reference), comparison.data,
                                               comparison.compared));
  }
  if (drawn && !arguments.render.empty()) drawn = draw_spheres(arguments, comparison);
  return drawn;
}

int run(const CompareArguments& arguments) {
  if (auto good = check(arguments); !good) return fail(good.error());
  const auto comparison =
      read_comparison(arguments.reference, arguments.materials, arguments.degrees);
  if (!comparison) return fail(comparison.error());
  if (auto drawn = draw(arguments, *comparison); !drawn) return fail(drawn.error());
  const auto found = errors_of(*comparison);
  if (!arguments.report.empty()) {
    const auto written =
        write(arguments.report, compare_json(arguments.reference, *comparison, found));
    if (!written) return fail(written.error());
  }
  const auto shown = print_table(compare_table(*comparison, found), arguments.report == "-");
  return shown ? exit_ok : fail(shown.error());
}

}  // namespace

Command add_compare_command(CLI::App& app) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App& command =
      arguments::add_command(app, "compare", "How far materials are from measured reflectance");
  arguments::set_footer(command, kFooter);
  arguments::add_option(command, "--reference", arguments->reference, "The measurements")
      .type_name("FILE")
      .required();
  arguments::add_option(command, "--material,-m", arguments->materials,
                        "Materials: JSON or files, as for 'gonio evaluate'; one or more")
      .type_name("M...")
      .required()
      .suggest(server::preset_names());
  arguments::add_flag(command, "--deg", arguments->degrees, "Angles of a CSV are in degrees");
  arguments::add_option(command, "--slices", arguments->slices,
                        "Where a picture of slices goes, a .png")
      .type_name("OUT");
  arguments::add_option(command, "--render", arguments->render,
                        "Where a picture of spheres goes, a .png")
      .type_name("OUT");
  arguments::add_option(command, "--report", arguments->report,
                        "Where the errors go as JSON; - is stdout, the table then goes to stderr")
      .type_name("OUT");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
