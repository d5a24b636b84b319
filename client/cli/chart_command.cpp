#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "chart/chart.h"
#include "client/cli/chart/figures.h"
#include "client/cli/chart/gnuplot.h"
#include "client/cli/chart/tables.h"
#include "client/cli/commands.h"
#include "client/cli/exit_codes.h"
#include "client/cli/output_file.h"
#include "client/cli/progress.h"

namespace gonio::cli {
namespace {

struct ChartArguments {
  std::string folder;
  bool quiet = false;
  bool quick = false;
};

// Makes the folder if it is not there.
Outcome make_folder(const std::string& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (!problem && std::filesystem::is_directory(folder, problem)) return Ok{};
  const std::string why = problem ? problem.message() : "it is no folder";
  return Error{ErrorCode::invalid_argument, "-o: " + folder + " cannot be made: " + why, "-o",
               folder, "a folder, or the name of one that can be made"};
}

Outcome write_file(const std::string& folder, const std::string& name, const std::string& bytes) {
  auto file = OutputFile::open((std::filesystem::path(folder) / name).string());
  if (!file) return file.error();
  if (auto written = file->write(bytes); !written) return written;
  return file->commit();
}

Outcome draw(const std::string& folder, const Figure& figure) {
  const std::string script = figure_script(figure);
  if (auto written = write_file(folder, figure.name + ".gp", script); !written) return written;
  const auto drawings = run_gnuplot(script, figure.name);
  if (!drawings) return drawings.error();
  for (const Drawing& drawing : *drawings) {
    if (auto written = write_file(folder, drawing.file, drawing.bytes); !written) return written;
  }
  return Ok{};
}

int run(const ChartArguments& arguments) {
  if (auto made = make_folder(arguments.folder); !made) return fail(made.error());
  chart::Options options;
  auto models = chart::chart_models(options);
  if (!models) return fail(models.error());
  Chart chart{chart::this_machine(), "", options.effort, "", {*models}};
  if (auto w = write_file(arguments.folder, "chart.json", chart_json(chart)); !w)
    return fail(w.error());
  for (const auto& table : chart.tables) {
    if (auto w = write_file(arguments.folder, table.name + ".csv", table_csv(table)); !w)
      return fail(w.error());
    for (const Figure& figure : figures_of(table)) {
      if (auto w = draw(arguments.folder, figure); !w) return fail(w.error());
    }
  }
  return exit_ok;
}

}  // namespace

Command add_chart_command(CLI::App& app) {
  auto arguments = std::make_shared<ChartArguments>();
  CLI::App* command = app.add_subcommand("chart", "Charts speed against accuracy on this machine");
  command->add_option("-o,--output", arguments->folder, "Folder for what is made")
      ->type_name("DIR")
      ->required();
  command->add_flag("--quiet,-q", arguments->quiet, "No progress bar and no table");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
