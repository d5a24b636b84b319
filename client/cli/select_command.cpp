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

// A file that is not there shows before the work on the materials before it.
Outcome check_reference(const SceneMaterial& material) {
  const std::filesystem::path path = material.reference;
  std::error_code ignored;
  const bool file = material.reference.find('{') == std::string::npos &&
                    (path.has_extension() || path.has_parent_path());
  if (!file || std::filesystem::exists(path, ignored)) return Ok{};
  return of_material(material.name, {ErrorCode::not_found, "no such file: " + path.string(),
                                     "reference", path.string(), "a file that can be read"});
}

// Where the results go. Opened before the work: what cannot be written shows before it.
struct Outputs {
  std::optional<OutputFile> report, choice;  // the choice of a scene without names
};

Outcome open_output(const std::string& file, std::optional<OutputFile>& output) {
  if (file.empty()) return Ok{};
  auto opened = OutputFile::open(file);
  if (!opened) return opened.error();
  output.emplace(std::move(*opened));
  return Ok{};
}

std::string file_in(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / (name + ".json")).string();
}

// Of a folder, whether a file can be made in it.
Outcome try_folder(const std::string& folder, const std::string& name) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  const auto file = OutputFile::open(file_in(folder, name));
  return file ? Outcome(Ok{}) : file.error();
}

Result<Outputs> open_outputs(const SelectArguments& arguments, const std::string& first) {
  const std::string& output = arguments.output;
  const auto apart =
      check_outputs({{"--output", output}, {"--report", arguments.report}},
                    {{"--reference", arguments.reference}, {"--scene", arguments.scene}});
  if (!apart) return apart.error();
  Outputs outputs;
  Outcome opened = open_output(arguments.report, outputs.report);
  if (opened && first.empty()) opened = open_output(output, outputs.choice);
  if (opened && !first.empty() && !output.empty()) opened = try_folder(output, first);
  if (!opened) return opened.error();
  return outputs;
}

Outcome write(OutputFile& output, const std::string& text) {
  if (auto written = output.write(text); !written) return written;
  return output.commit();
}

// A choice that is the reference itself is not written: it is where it was.
Outcome write_all(const SelectArguments& arguments, Outputs& outputs,
                  const std::vector<NamedSelection>& found) {
  Outcome written = Ok{};
  if (outputs.report) written = write(*outputs.report, select_json(found));
  for (const auto& [name, selection] : found) {
    const bool wanted = !arguments.output.empty() && selection.choice && selection.choice->material;
    if (!written || !wanted) continue;
    if (!name.empty()) written = open_output(file_in(arguments.output, name), outputs.choice);
    if (written) written = write(*outputs.choice, selection.choice->material->to_json() + "\n");
  }
  return written;
}

Outcome show_table(const SelectArguments& arguments, const std::vector<NamedSelection>& found) {
  if (arguments.quiet) return Ok{};
  const bool taken = arguments.output == "-" || arguments.report == "-";
  const bool one = found[0].name.empty();
  return print_table(one ? select_table(found[0].selection, arguments.all) : scene_table(found),
                     taken);
}

int run(SelectArguments& arguments) {
  arguments.options.whole_front = !arguments.no_front;
  const auto materials = read_scene(arguments.scene, arguments.reference);
  if (!materials) return fail(materials.error());
  if (arguments.output == "-" && !(*materials)[0].name.empty())
    return fail(bad_value("--output", "-, for materials by name", "a folder"));
  if (!arguments.costs.empty()) {
    auto costs = read_costs(arguments.costs);
    if (!costs) return fail(costs.error());
    arguments.options.costs = std::move(*costs);
  }
  for (const SceneMaterial& material : *materials) {
    if (auto there = check_reference(material); !there) return fail(there.error());
  }
  auto outputs = open_outputs(arguments, (*materials)[0].name);
  if (!outputs) return fail(outputs.error());
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  const auto found = select_all(connection->client, *materials, arguments);
  if (!found) return fail(found.error());
  if (auto written = write_all(arguments, *outputs, *found); !written) return fail(written.error());
  if (auto shown = show_table(arguments, *found); !shown) return fail(shown.error());
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
