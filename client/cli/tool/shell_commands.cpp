// `gonio completion` and `gonio man`: what an installation makes of the arguments. Each builds the
// whole tool once more, so that what it prints is what the tool parses.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "client/cli/commands/commands.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/output_file.h"
#include "client/cli/tool/tool.h"
#include "server/arguments/completion.h"
#include "server/arguments/man_page.h"
#include "server/arguments/words.h"

namespace gonio::cli {
namespace {

constexpr const char* kCompletionFooter = R"(
Examples:
  source <(gonio completion bash)                              in this shell
  gonio completion fish > ~/.config/fish/completions/gonio.fish
An installation puts them where shells look.)";

constexpr const char* kManFooter = R"(
Examples:
  gonio man evaluate | man -l -      one page
  gonio man -o man1                  all of them, into a folder)";

int complete(const std::string& shell) {
  CLI::App app;
  add_commands(app);
  const auto shown = print(arguments::completion_script(app, shell));
  return shown ? exit_ok : fail(shown.error());
}

struct ManArguments {
  std::string command, folder;
};

std::vector<CLI::App*> pages_of(CLI::App& app) {
  auto pages = app.get_subcommands([](CLI::App* command) { return !command->get_group().empty(); });
  pages.insert(pages.begin(), &app);
  return pages;
}

std::string program_of(const CLI::App& app, const CLI::App& page) {
  return &app == &page ? "" : app.get_name();
}

Outcome write_pages(CLI::App& app, const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  for (const CLI::App* page : pages_of(app)) {
    const std::string program = program_of(app, *page);
    auto output = OutputFile::open((folder / arguments::man_page_name(*page, program)).string());
    if (!output) return output.error();
    const auto written =
        output->write_whole(arguments::man_page(*page, program, program_version()));
    if (!written) return written;
  }
  return Ok{};
}

Outcome print_page(CLI::App& app, const std::string& name) {
  for (const CLI::App* page : pages_of(app)) {
    if (page->get_name() != (name.empty() ? app.get_name() : name)) continue;
    return print(arguments::man_page(*page, program_of(app, *page), program_version()));
  }
  return bad_value("COMMAND", '"' + name + '"', "a command of gonio");
}

int show_manual(const ManArguments& wanted) {
  CLI::App app;
  add_commands(app);
  const Outcome done =
      wanted.folder.empty() ? print_page(app, wanted.command) : write_pages(app, wanted.folder);
  return done ? exit_ok : fail(done.error());
}

}  // namespace

Command add_completion_command(CLI::App& app) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("completion", "Print what completes gonio's arguments in a shell");
  command->footer(kCompletionFooter);
  command->add_option("SHELL", *shell, "bash, fish or zsh")
      ->type_name("")
      ->required()
      ->check(arguments::one_of(arguments::shells()));
  return {command, [shell] { return complete(*shell); }};
}

Command add_man_command(CLI::App& app) {
  auto wanted = std::make_shared<ManArguments>();
  CLI::App* command = app.add_subcommand("man", "Print the manual page of gonio or of a command");
  std::vector<std::string> names;
  for (const CLI::App* page : pages_of(app)) names.push_back(page->get_name());
  command->footer(kManFooter);
  command->add_option("COMMAND", wanted->command, "The command; else gonio itself")
      ->type_name("")
      ->check(arguments::one_of(names));
  command
      ->add_option("-o,--output", wanted->folder,
                   "A folder for all pages, in place of printing one")
      ->type_name("DIR");
  return {command, [wanted] { return show_manual(*wanted); }};
}

}  // namespace gonio::cli
