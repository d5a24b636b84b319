#include "client/cli/tool/tool.h"

#include <CLI/CLI.hpp>
#include <array>
#include <string>

#include "base/exit_code.h"
#include "gonio/base/version.h"

namespace gonio::cli {
namespace {

constexpr const char* kDescription =
    R"(gonio evaluates materials (BRDFs): how much light each one reflects from one direction into another.

It does the work itself, or asks a goniod server (--server ADDRESS or $GONIO_SERVER) to do it.
)";

constexpr const char* kExamples = R"(
Examples:
  gonio models                        what there is
  gonio models ggx                    one model's manual page
  gonio models --presets              substances by name
  gonio evaluate --material '{"model": "lambertian", "parameters": {"rd": 0.5}}' \
      --grid theta_i=30,theta_o=0:80:9 --deg
  gonio evaluate --material gold.json --pairs pairs.csv -o values.npy -v
  gonio sample --material gold.json --wi 0.6,0,0.8 --count 1000
  gonio albedo --material copper --theta 0,30,60
  gonio render --material gold.json --light sky -o gold.png
  gonio lobe --material gold.json --theta 30,60,80 -o lobe.png
  gonio fit --data nickel.binary --model cook_torrance -o nickel.json
  gonio compare --reference nickel.binary --material nickel.json
  gonio put nickel nickel.binary      store a measured material on a server
  gonio assess --material gold.json   where it fails, and a verdict
  gonio chart -o chart                speed against accuracy on this machine
  gonio select --reference nickel.binary --scene scene.json -o nickel.json
  gonio completion bash               what completes all of this in a shell
  gonio evaluate --help               everything about it; so for each command

)";

// A verdict belongs to some commands alone.
std::string exit_status_of(const std::string& command) {
  if (command == "assess" || command == "select") {
    return exit_status_text(
        std::array{exit_ok, exit_failed, exit_bad_input, exit_unreachable, exit_bad_verdict});
  }
  return exit_status_text(std::array{exit_ok, exit_failed, exit_bad_input, exit_unreachable});
}

}  // namespace

std::string program_version() { return std::string(kProgram) + " " + kVersion; }

std::vector<Command> add_commands(CLI::App& app) {
  app.name(kProgram);
  app.description(kDescription);
  app.set_version_flag("--version", program_version());
  app.require_subcommand(1);
  app.get_formatter()->column_width(30);
  std::vector<Command> commands{
      add_models_command(app),     add_evaluate_command(app), add_sample_command(app),
      add_albedo_command(app),     add_lobe_command(app),     add_render_command(app),
      add_fit_command(app),        add_compare_command(app),  add_put_command(app),
      add_assess_command(app),     add_select_command(app),   add_chart_command(app),
      add_completion_command(app), add_man_command(app)};
  for (const Command& command : commands) {
    CLI::App& arguments = *command.arguments;
    const std::string footer = arguments.get_footer();
    arguments.footer((footer.empty() ? "\n" : footer + "\n\n") +
                     exit_status_of(arguments.get_name()));
  }
  app.footer(kExamples + exit_status_of("select"));  // last: a command would inherit it
  return commands;
}

}  // namespace gonio::cli
