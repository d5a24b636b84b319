#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

#include "client/cli/commands.h"
#include "client/cli/exit_codes.h"
#include "client/cli/fit_table.h"
#include "client/cli/local_reference.h"
#include "client/cli/text.h"
#include "fit/metrics.h"
#include "server/materials.h"

namespace gonio::cli {
namespace {

constexpr const char* kFooter = R"(
The reference is a file of measurements, as for 'gonio fit'. Errors: L1 is sum |f - m| cos / sum m cos, RMSE
of f cos in 1/sr, LOG and CBRT the differences of log(1 + f cos) and of cube roots; each for all pairs,
for both angles up to 80 degrees, and for the rest. Below each material: what is measured and what the
material reflects within 25 degrees of the mirror direction, so near to the light, and elsewhere, as
parts of all that is measured. Works in this process.

Example:
  gonio compare --reference nickel.binary --material cook_torrance.json ggx.json)";

struct CompareArguments {
  std::string reference;
  std::vector<std::string> materials;
  bool degrees = false;
};

client::FitErrors cells(const fit::Errors& errors) {
  return {errors.l1, errors.rmse, errors.log, errors.cbrt, errors.pairs};
}

std::string region(const char* name, const fit::Region& of) {
  char text[96];
  std::snprintf(text, sizeof(text), "%s %.3g of %.3g", name, of.fitted, of.measured);
  return text;
}

std::string row(const std::string& name, const fit::Comparison& comparison, std::size_t width) {
  const fit::Regions& regions = comparison.regions;
  return padded(name, width) +
         error_cells({cells(comparison.errors.all), cells(comparison.errors.below_80),
                      cells(comparison.errors.above_80)}) +
         "\n    " + region("mirror", regions.mirror) + ", " +
         region("toward the light", regions.toward_light) + ", " +
         region("elsewhere", regions.elsewhere) + "\n";
}

Outcome check_channels(const std::string& name, const Material& material, const fit::Data& data) {
  if (material.channels() == 1 || material.channels() == data.channels) return Ok{};
  return bad_value("--material " + name,
                   "a material of " + std::to_string(material.channels()) + " channels",
                   "1 or " + std::to_string(data.channels) + ", those of the reference");
}

int run(const CompareArguments& arguments) {
  Materials materials;
  materials.allow_local_files();
  const auto data = local_data(materials, arguments.reference, arguments.degrees);
  if (!data) return fail(data.error());
  constexpr std::size_t kName = 28;
  std::string text = std::to_string(data->size()) + " pairs, " +
                     std::to_string(data->left_out.total()) + " left out\n\n" + error_head(kName) +
                     "\n";
  for (const std::string& argument : arguments.materials) {
    const auto material = local_material(materials, argument);
    if (!material) return fail(material.error());
    if (auto agree = check_channels(argument, *material, *data); !agree) return fail(agree.error());
    const bool json = argument.find('{') != std::string::npos;
    const std::string name = json ? argument : std::filesystem::path(argument).filename().string();
    text += row(name, fit::compare(*material, *data, 0), kName);
  }
  std::fputs(text.c_str(), stdout);
  return exit_ok;
}

}  // namespace

Command add_compare_command(CLI::App& app) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command =
      app.add_subcommand("compare", "How far materials are from measured reflectance");
  command->footer(kFooter);
  command->add_option("--reference", arguments->reference, "The measurements")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--material,-m", arguments->materials,
                   "Materials: JSON or files, as for 'gonio evaluate'; one or more")
      ->type_name("M...")
      ->required();
  command->add_flag("--deg", arguments->degrees, "Angles of a CSV are in degrees");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
