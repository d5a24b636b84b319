// gonio: the command line.
#include <CLI/CLI.hpp>
#include <exception>
#include <string>

#include "client/cli/commands.h"
#include "client/cli/exit_codes.h"
#include "client/cli/output_file.h"
#include "client/cli/terminal.h"
#include "gonio/base/version.h"

namespace {

constexpr const char* kDescription =
    R"(gonio evaluates materials (BRDFs): how much light each one reflects from one direction into another.

It does the work itself, or asks a goniod server (--server ADDRESS or $GONIO_SERVER) to do it.
)";

constexpr const char* kFooter = R"(
Examples:
  gonio models                        what there is
  gonio models ggx                    one model's manual page
  gonio models --presets              substances by name
  gonio evaluate --material '{"model": "lambertian", "parameters": {"rd": 0.5}}' \
      --grid theta_i=30,theta_o=0:80:9 --deg
  gonio evaluate --material gold.json --pairs pairs.csv -o values.npy -v
  gonio sample --material gold.json --wi 0.6,0,0.8 --count 1000
  gonio albedo --material gold.json --theta 0,30,60
  gonio render --material gold.json --light sky -o gold.png
  gonio lobe --material gold.json --theta 30,60,80 -o lobe.png
  gonio fit --data nickel.binary --model cook_torrance -o nickel.json
  gonio compare --reference nickel.binary --material nickel.json
  gonio put nickel nickel.binary      store a measured material on a server
  gonio assess --material gold.json   where it fails, and a verdict
  gonio chart -o chart                speed against accuracy on this machine
  gonio select --reference nickel.binary --scene scene.json -o nickel.json
  gonio evaluate --help               everything about it; so for each command

Exit status: 0 done; 1 failed on the way; 2 wrong arguments, files or materials;
3 no answer from the server (not there, too busy, or past the deadline); 4 not within its limits
(gonio assess), or nothing good enough (gonio select).)";

}  // namespace

int main(int argc, char** argv) try {
  using gonio::cli::exit_bad_input;
  CLI::App app(kDescription, "gonio");
  app.footer(kFooter);
  app.set_version_flag("--version", std::string("gonio ") + gonio::kVersion);
  app.require_subcommand(1);
  app.get_formatter()->column_width(30);
  const auto commands = {gonio::cli::add_models_command(app), gonio::cli::add_evaluate_command(app),
                         gonio::cli::add_sample_command(app), gonio::cli::add_albedo_command(app),
                         gonio::cli::add_lobe_command(app),   gonio::cli::add_render_command(app),
                         gonio::cli::add_fit_command(app),    gonio::cli::add_compare_command(app),
                         gonio::cli::add_put_command(app),    gonio::cli::add_assess_command(app),
                         gonio::cli::add_select_command(app), gonio::cli::add_chart_command(app)};
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wanted) {  // --help, --version
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    gonio::cli::print_error(error.what());
    gonio::cli::print_lines("Try 'gonio --help'.\n");
    return exit_bad_input;
  }
  gonio::cli::handle_signals();
  for (const auto& command : commands) {
    if (command.arguments->parsed()) return command.run();
  }
  return exit_bad_input;
} catch (const std::exception& error) {  // out of memory
  gonio::cli::print_error(error.what());
  return gonio::cli::exit_failed;
}
