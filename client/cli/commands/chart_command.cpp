#include <memory>

#include "client/cli/chart/arguments.h"
#include "client/cli/chart/files.h"
#include "client/cli/chart/measure.h"
#include "client/cli/commands/commands.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/output_file.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

constexpr const char* kFooter = R"(
Parts, each a table (in chart.json, and PART.csv) with figures (FIGURE.svg, .png, and .gp for gnuplot):
  models          the models in both precisions on each instruction set, and scalar loops as printed:
                  ns an evaluation against the error to the formula in long double
  fits            models fitted to a measured material, and its table: ns and bytes against error
  approximations  Fresnel's term as a constant, by Schlick and exact; what publications print wrongly
  wire            sizes and forms of calls, types of directions: latency, pairs a second, error
  sampling        strategies of sampling: ns a sample against variance
  resolution      a measured table in fewer cells, nearest and interpolated: bytes against error

Times are the best of repetitions that take turns; bars go to the upper quartile. Grey steps are the
choices that no other one beats. Leave the machine to it for its minute, or see it in the bars.

With --server the core's parts are measured on the server's machine, and the wire to it.

Examples:
  gonio chart -o chart
  gonio chart -o chart --data nickel.binary --parts fits,resolution)";

int run(const ChartArguments& arguments) {
  if (auto made = make_folder(arguments.folder); !made) return fail(made.error());
  const auto chart = measure(arguments);
  if (!chart) return fail(chart.error());
  if (auto written = write_tables(arguments.folder, *chart); !written) return fail(written.error());
  if (auto drawn = write_figures(arguments.folder, *chart); !drawn) return fail(drawn.error());
  if (arguments.quiet) return exit_ok;
  const auto shown = print(summary_of(arguments.folder, *chart));
  return shown ? exit_ok : fail(shown.error());
}

}  // namespace

Command add_chart_command(CLI::App& app) {
  auto arguments = std::make_shared<ChartArguments>();
  CLI::App& command = arguments::add_command(
      app, "chart", "Speed against accuracy on this machine: tables and figures");
  arguments::set_footer(command, kFooter);
  add_chart_options(command, *arguments);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
