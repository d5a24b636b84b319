// The subcommands. Each adds itself to the tool's arguments and hands back what to run if it is
// chosen.
#pragma once

#include <functional>

namespace CLI {  // NOLINT(readability-identifier-naming): theirs
class App;
}

namespace gonio::cli {

// A subcommand's arguments and its run(), which returns the exit code.
struct Command {
  CLI::App* arguments;
  std::function<int()> run;
};

Command add_models_command(CLI::App& app);
Command add_evaluate_command(CLI::App& app);
Command add_sample_command(CLI::App& app);
Command add_albedo_command(CLI::App& app);
Command add_lobe_command(CLI::App& app);
Command add_render_command(CLI::App& app);
Command add_fit_command(CLI::App& app);
Command add_compare_command(CLI::App& app);
Command add_put_command(CLI::App& app);
Command add_assess_command(CLI::App& app);
Command add_select_command(CLI::App& app);
Command add_chart_command(CLI::App& app);
Command add_completion_command(CLI::App& app);
Command add_man_command(CLI::App& app);  // after the others, of which it has pages

}  // namespace gonio::cli
