#include "client/cli/chart/files.h"

#include <filesystem>
#include <optional>
#include <system_error>

#include "client/cli/chart/figures.h"
#include "client/cli/chart/panel/gnuplot.h"
#include "client/cli/output/output_file.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

std::string path_in(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

Outcome write_file(const std::string& folder, const std::string& name, const std::string& bytes) {
  auto file = OutputFile::open(path_in(folder, name));
  if (!file) return file.error();
  return file->write_whole(bytes);
}

Outcome draw(const std::string& folder, const Figure& figure, const std::string& script) {
  const auto drawings = run_gnuplot(script, figure.name);
  if (!drawings) return drawings.error();
  for (const Drawing& drawing : *drawings) {
    if (auto written = write_file(folder, drawing.file, drawing.bytes); !written) return written;
  }
  return Ok{};
}

Error not_drawn(const std::string& folder, const Error& why) {
  return {why.code == ErrorCode::not_found ? ErrorCode::internal : why.code,
          why.message + ": no figures are drawn; the tables and the scripts for gnuplot are in " +
              folder,
          {},
          {},
          {}};
}

}  // namespace

Outcome make_folder(const std::string& folder) {
  if (folder == "-") return bad_value("--output", "-", "a folder: there are many files");
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem || !std::filesystem::is_directory(folder, problem)) {
    const std::string why = problem ? problem.message() : "it is no folder";
    return Error{ErrorCode::invalid_argument, "-o: " + shown(folder) + " cannot be made: " + why,
                 "-o", shown(folder), "a folder, or the name of one that can be made"};
  }
  // What cannot be written shows before the work.
  const auto file = OutputFile::open(path_in(folder, "chart.json"));
  if (!file) return file.error();
  return Ok{};
}

Outcome write_tables(const std::string& folder, const Chart& chart) {
  for (const chart::Table& table : chart.tables) {
    if (auto written = write_file(folder, table.name + ".csv", table_csv(table)); !written)
      return written;
  }
  return write_file(folder, "chart.json", chart_json(chart));
}

Outcome write_figures(const std::string& folder, const Chart& chart) {
  std::optional<Error> failure;
  for (const chart::Table& table : chart.tables) {
    for (const Figure& figure : figures_of(table)) {
      const std::string script = figure_script(figure);
      if (auto written = write_file(folder, figure.name + ".gp", script); !written) return written;
      if (failure) continue;
      if (auto drawn = draw(folder, figure, script); !drawn) failure = drawn.error();
    }
  }
  if (failure) return not_drawn(folder, *failure);
  return Ok{};
}

std::string summary_of(const std::string& folder, const Chart& chart) {
  std::string text =
      chart.machine.processor + ", " + std::to_string(chart.machine.cores) + " cores\n";
  for (const chart::Table& table : chart.tables) {
    text += table.title + "\n  " + path_in(folder, table.name + ".csv");
    for (const Figure& figure : figures_of(table))
      text += ", " + path_in(folder, figure.name + ".png");
    text += "\n";
  }
  return text + "all of it: " + path_in(folder, "chart.json") + "\n";
}

}  // namespace gonio::cli
