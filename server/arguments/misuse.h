// What is said of a command line that cannot be parsed. Thread safety: functions without state.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gonio::arguments {

// What is wrong, in one sentence. A command or an option that does not exist comes before whatever
// else is missing because of it, and the nearest one is asked for; an argument of no option that is
// a file is offered to the option that wants it.
std::string misuse(const CLI::App& app, const CLI::ParseError& error);

// "Try 'gonio evaluate --help'.", of the command that was given.
std::string where_to_read(const CLI::App& app);

}  // namespace gonio::arguments
