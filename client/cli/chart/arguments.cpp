#include "client/cli/chart/arguments.h"

#include <algorithm>

#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

std::vector<std::string> part_names() {
  std::vector<std::string> names;
  for (const chart::Part& part : chart::all_parts()) names.push_back(name_of(part));
  return names;
}

}  // namespace

std::string name_of(const chart::Part& part) {
  return part.name == "directions" ? "wire" : std::string(part.name);
}

bool ChartArguments::wants(const std::string& part) const {
  return parts.empty() || std::ranges::find(parts, part) != parts.end();
}

void add_chart_options(CLI::App& command, ChartArguments& arguments) {
  arguments::add_option(command, "-o,--output", arguments.folder,
                        "The folder for all of it; made if it is not there")
      .type_name("DIR")
      .required();
  arguments::add_option(
      command, "--data", arguments.data,
      "A measured material for fits and resolution: a file as 'gonio fit' reads it, or the "
      "name of a server's; without one, a glossy paint is made up")
      .type_name("FILE");
  arguments::add_flag(command, "--deg", arguments.degrees,
                      "A CSV's angles are in degrees, not radians");
  arguments::add_option(command, "--parts", arguments.parts, "Only these, separated by commas")
      .type_name("PART")
      .delimiter(',')
      .one_of(part_names());
  add_connection_options(command, arguments.connection);
  arguments::add_flag(command, "--quick", arguments.quick,
                      "Fewer and shorter repetitions: rough times");
  arguments::add_flag(command, "--quiet,-q", arguments.quiet,
                      "No progress bar, and do not list the files");
}

}  // namespace gonio::cli
