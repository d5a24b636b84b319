// gonio: the command line.
#include <CLI/CLI.hpp>
#include <exception>

#include "client/cli/output/exit_codes.h"
#include "client/cli/output/output_file.h"
#include "client/cli/output/terminal.h"
#include "client/cli/tool/tool.h"
#include "server/arguments/misuse.h"

int main(int argc, char** argv) try {
  CLI::App app;
  const auto commands = gonio::cli::add_commands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wanted) {  // --help, --version
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    gonio::cli::print_error(gonio::arguments::misuse(app, error));
    gonio::cli::print_lines(gonio::arguments::where_to_read(app) + "\n");
    return gonio::exit_bad_input;
  }
  gonio::cli::handle_signals();
  for (const auto& command : commands) {
    if (command.arguments->parsed()) return command.run();
  }
  return gonio::exit_bad_input;
} catch (const std::exception& error) {  // out of memory
  gonio::cli::print_error(error.what());
  return gonio::exit_failed;
}
