#include "client/cli/report/select_outputs.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "client/cli/output/check_outputs.h"

namespace gonio::cli {
namespace {

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

// Whether a file can be made in the folder.
Outcome try_folder(const std::string& folder, const std::string& name) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  const auto file = OutputFile::open(file_in(folder, name));
  return file ? Outcome(Ok{}) : file.error();
}

Outcome check_places(const SelectArguments& arguments,
                     const std::vector<SceneMaterial>& materials) {
  std::vector<NamedFile> outputs{{"--report", arguments.report}};
  std::vector<NamedFile> inputs{{"--scene", arguments.scene}, {"--costs", arguments.costs}};
  for (const SceneMaterial& material : materials) {
    const bool named = !material.name.empty();
    if (material.reference.find('{') == std::string::npos)
      inputs.push_back(
          {named ? "the reference of " + material.name : "--reference", material.reference});
    if (named && !arguments.output.empty())
      outputs.push_back({"--output", file_in(arguments.output, material.name)});
    if (!named) outputs.push_back({"--output", arguments.output});
  }
  return check_outputs(outputs, inputs);
}

}  // namespace

Result<SelectOutputs> SelectOutputs::open(const SelectArguments& arguments,
                                          const std::vector<SceneMaterial>& materials) {
  if (auto apart = check_places(arguments, materials); !apart) return apart.error();
  const bool folder = !materials[0].name.empty();
  for (const NamedFile& file : {NamedFile{"--report", arguments.report},
                                NamedFile{"--output", folder ? std::string() : arguments.output}}) {
    if (auto json = check_extension(file, {".json"}); !json) return json.error();
  }
  SelectOutputs outputs;
  outputs.output_ = arguments.output;
  const std::string& first = materials[0].name;
  Outcome opened = Ok{};
  if (first.empty()) {
    opened = open_output(arguments.output, outputs.choice_);
  } else if (!arguments.output.empty()) {
    opened = try_folder(arguments.output, first);
  }
  if (opened) opened = open_output(arguments.report, outputs.report_);
  if (!opened) return opened.error();
  return outputs;
}

Outcome SelectOutputs::write(const std::vector<NamedSelection>& found) {
  Outcome written = Ok{};
  if (report_) written = report_->write_whole(select_json(found));
  for (const auto& [name, selection] : found) {
    const bool wanted = !output_.empty() && selection.choice && selection.choice->material;
    if (!written || !wanted) continue;
    if (!name.empty()) written = open_output(file_in(output_, name), choice_);
    if (written) written = choice_->write_whole(selection.choice->material->to_json() + "\n");
  }
  return written;
}

}  // namespace gonio::cli
