#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "client/cli/arguments/material_argument.h"
#include "client/cli/arguments/select_arguments.h"
#include "client/cli/commands/commands.h"
#include "client/cli/input/file_kind.h"
#include "client/cli/input/measured_input.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/output_file.h"
#include "client/cli/output/progress.h"
#include "client/cli/output/terminal.h"
#include "client/cli/report/select_outputs.h"
#include "client/cli/report/select_report.h"
#include "client/cli/scene/scene_file.h"
#include "gonio/base/shown.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

bool is_json(const std::string& reference) { return reference.find('{') != std::string::npos; }

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
  const bool embedded = arguments.connection.server.empty();
  const bool table =
      extension_of(argument) == ".binary" || kind_of_file(argument) == FileKind::merl;
  const bool pairs =
      !is_json(argument) && (argument == "-" || (table && !embedded) || holds_pairs(argument));
  Reference reference;
  if (pairs) {
    auto input = read_measured(argument, false, arguments.degrees);
    if (!input) return input.error();
    if (input->raised > 0 && !arguments.quiet) print_note(argument + ": " + raised_text(*input));
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

// A file that is not there shows before the work on the materials before it. A server's names may
// have dots in them.
Outcome check_reference(const SceneMaterial& material) {
  const std::string& name = material.reference;
  const std::string extension = extension_of(name);
  const bool file = !is_json(name) && (extension == ".json" || extension == ".binary" ||
                                       holds_pairs(name) || name.find('/') != std::string::npos);
  std::error_code ignored;
  if (!file || std::filesystem::exists(name, ignored)) return Ok{};
  return of_material(material.name,
                     {ErrorCode::not_found, "no such file: " + shown(name) + near_files(name),
                      "reference", shown(name), "a file that can be read"});
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
  auto outputs = SelectOutputs::open(arguments, *materials);
  if (!outputs) return fail(outputs.error());
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  const auto found = select_all(connection->client, *materials, arguments);
  if (!found) return fail(found.error());
  if (auto written = outputs->write(*found); !written) return fail(written.error());
  if (auto shown = show_table(arguments, *found); !shown) return fail(shown.error());
  const bool all = std::all_of(found->begin(), found->end(),
                               [](const auto& each) { return each.selection.choice.has_value(); });
  return all ? exit_ok : exit_bad_verdict;
}

}  // namespace

Command add_select_command(CLI::App& app) {
  auto arguments = std::make_shared<SelectArguments>();
  CLI::App& command = arguments::add_command(
      app, "select", "The cheapest material that is good enough for a scene");
  add_select_options(command, *arguments);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
