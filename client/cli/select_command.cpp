#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "client/cli/commands.h"
#include "client/cli/exit_codes.h"
#include "client/cli/material_argument.h"
#include "client/cli/measured_input.h"
#include "client/cli/output_file.h"
#include "client/cli/progress.h"
#include "client/cli/scene_file.h"
#include "client/cli/select_arguments.h"
#include "client/cli/select_report.h"

namespace gonio::cli {
namespace {

// What is selected for: a material as it is, or measured pairs, which `input` holds.
struct Reference {
  MeasuredInput input;
  std::optional<client::Material> material;

  [[nodiscard]] client::SelectReference given() const {
    if (material) return *material;
    return input.data();
  }
};

// Tables that only this machine has travel to a server as pairs.
Result<Reference> read_reference(const std::string& argument, const SelectArguments& arguments) {
  constexpr std::array<std::string_view, 6> kPairs{".brdf", ".bsdf", ".dat",
                                                   ".alta", ".csv",  ".npy"};
  const bool embedded = arguments.connection.server.empty();
  const bool json = argument.find('{') != std::string::npos;
  const std::string extension =
      json ? std::string() : std::filesystem::path(argument).extension().string();
  const bool pairs = argument == "-" || (extension == ".binary" && !embedded) ||
                     std::find(kPairs.begin(), kPairs.end(), extension) != kPairs.end();
  Reference reference;
  if (pairs) {
    auto input = read_measured(argument, false, arguments.degrees);
    if (!input) return input.error();
    reference.input = std::move(*input);
    return reference;
  }
  auto material = read_material(argument, embedded);
  if (!material) return material.error();
  reference.material = std::move(*material);
  return reference;
}

Result<std::vector<NamedSelection>> select_all(const client::Client& client,
                                               const std::vector<SceneMaterial>& materials,
                                               const SelectArguments& arguments) {
  Progress progress(!arguments.quiet, "candidates");
  std::vector<NamedSelection> found;
  for (const SceneMaterial& material : materials) {
    const auto reference = read_reference(material.reference, arguments);
    if (!reference) return of_material(material.name, reference.error());
    client::SelectWatch watch;
    watch.progress = [&](const client::SelectProgress& at) {
      const double part =
          at.of == 0 ? 0 : static_cast<double>(at.done) / static_cast<double>(at.of);
      progress.show(
          (static_cast<double>(found.size()) + part) / static_cast<double>(materials.size()),
          material.name + " " + (at.candidate.empty() ? at.stage : at.candidate));
    };
    auto selection = client.select(reference->given(), material.needs, arguments.options, watch);
    if (!selection) return of_material(material.name, selection.error());
    found.push_back({material.name, std::move(*selection)});
  }
  return found;
}

Outcome write(const std::string& file, const std::string& text) {
  if (file.empty()) return Ok{};
  auto output = OutputFile::open(file);
  if (!output) return output.error();
  if (auto written = output->write(text); !written) return written;
  return output->commit();
}

// A scene's materials go to files of their names in a folder. A choice that is the reference itself
// is not written: it is where it was.
Outcome write_materials(const std::string& output, const std::vector<NamedSelection>& found) {
  if (output.empty()) return Ok{};
  for (const auto& [name, selection] : found) {
    if (!selection.choice || !selection.choice->material) continue;
    std::string file = output;
    if (!name.empty()) {
      std::error_code failed;
      std::filesystem::create_directories(output, failed);
      file = (std::filesystem::path(output) / (name + ".json")).string();
    }
    if (auto written = write(file, selection.choice->material->to_json() + "\n"); !written)
      return written;
  }
  return Ok{};
}

int run(SelectArguments& arguments) {
  const auto materials = read_scene(arguments.scene, arguments.reference);
  if (!materials) return fail(materials.error());
  if (arguments.output == "-" && !(*materials)[0].name.empty())
    return fail(bad_value("--output", "-, for materials by name", "a folder"));
  if (!arguments.costs.empty()) {
    auto costs = read_costs(arguments.costs);
    if (!costs) return fail(costs.error());
    arguments.options.costs = std::move(*costs);
  }
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  const auto found = select_all(connection->client, *materials, arguments);
  if (!found) return fail(found.error());
  Outcome written = write(arguments.report, select_json(*found));
  if (written) written = write_materials(arguments.output, *found);
  if (!written) return fail(written.error());
  // The table must not stand among what is read from standard output.
  const bool taken = arguments.output == "-" || arguments.report == "-";
  const bool one = (*found)[0].name.empty();
  if (!arguments.quiet) {
    const std::string table =
        one ? select_table((*found)[0].selection, arguments.all) : scene_table(*found);
    std::fputs(table.c_str(), taken ? stderr : stdout);
  }
  const bool all = std::all_of(found->begin(), found->end(),
                               [](const auto& each) { return each.selection.choice.has_value(); });
  return all ? exit_ok : exit_bad_verdict;
}

}  // namespace

Command add_select_command(CLI::App& app) {
  auto arguments = std::make_shared<SelectArguments>();
  CLI::App* command =
      app.add_subcommand("select", "The cheapest material that is good enough for a scene");
  add_select_options(*command, *arguments);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
