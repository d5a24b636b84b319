#include "server/arguments/misuse.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/near_names.h"
#include "base/text/join.h"
#include "gonio/base/shown.h"

namespace gonio::arguments {
namespace {

// The options that take what a command is about, in the order in which files are offered to them.
constexpr std::string_view kFileOptions[] = {"reference", "material", "data", "materials"};

const CLI::App& given_command(const CLI::App& app) {
  const auto given = app.get_subcommands();
  return given.empty() ? app : *given.front();
}

std::string full_name(const CLI::App& app, const CLI::App& command) {
  return &app == &command ? app.get_name() : app.get_name() + " " + command.get_name();
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!command->get_group().empty()) names.push_back(command->get_name());
  }
  return names;
}

std::string in_quotes(std::string_view text) { return "\"" + shown(text, kQuotedLength) + "\""; }

bool is_option(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-' && (argument[1] < '0' || argument[1] > '9') &&
         argument[1] != '.';
}

std::string unknown_option(const CLI::App& app, const CLI::App& command,
                           const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  const auto known = options_of(command);
  return in_quotes(name) + " is not an option of '" + full_name(app, command) + "'" +
         did_you_mean(name, std::span<const std::string>(known));
}

bool is_file(const std::string& argument) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(argument, ignored);
}

// "--material", if it is not given yet.
std::string option_for_a_file(const CLI::App& command) {
  for (const std::string_view name : kFileOptions) {
    const CLI::Option* option = command.get_option_no_throw("--" + std::string(name));
    if (option != nullptr && option->count() == 0) return "--" + std::string(name);
  }
  return {};
}

std::string extra_argument(const CLI::App& app, const CLI::App& command,
                           const std::string& argument) {
  const std::string wanted = option_for_a_file(command);
  const bool looks_like_one = std::filesystem::path(argument).has_extension();
  std::string text =
      in_quotes(argument) + " is not an argument of '" + full_name(app, command) + "'";
  if (!wanted.empty() && (is_file(argument) || looks_like_one))
    text += "; did you mean \"" + wanted + " " + shown(argument, kQuotedLength) + "\"?";
  return text;
}

std::string unknown_command(const CLI::App& app, const std::string& argument) {
  const auto commands = commands_of(app);
  const std::string all = joined(commands);
  if (is_file(argument)) {
    return in_quotes(argument) + " is a file; a command must come first: " + app.get_name() +
           " COMMAND, one of " + all;
  }
  std::vector<std::string> known = commands;
  for (const std::string& option : options_of(app)) known.push_back(option);
  return in_quotes(argument) + " is not a command; the commands are " + all +
         did_you_mean(argument, std::span<const std::string>(known));
}

}  // namespace

std::string misuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = given_command(app);
  // What a required option's absence or the count of arguments says may follow from a wrong name.
  const bool about_values = dynamic_cast<const CLI::ValidationError*>(&error) != nullptr ||
                            dynamic_cast<const CLI::ConversionError*>(&error) != nullptr;
  const std::vector<std::string> rest = command.remaining();
  if (about_values || rest.empty()) return error.what();
  const auto option = std::find_if(rest.begin(), rest.end(), is_option);
  if (option != rest.end()) return unknown_option(app, command, *option);
  const bool root = &command == &app && !commands_of(app).empty();
  return root ? unknown_command(app, rest.front()) : extra_argument(app, command, rest.front());
}

std::string where_to_read(const CLI::App& app) {
  return "Try '" + full_name(app, given_command(app)) + " --help'.";
}

}  // namespace gonio::arguments
