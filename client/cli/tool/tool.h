// The tool's arguments as a whole: what main() parses, and manual pages and completion are made
// from. Thread safety: used by one thread.
#pragma once

#include <string>
#include <vector>

#include "client/cli/commands/commands.h"

namespace gonio::cli {

inline constexpr const char* kProgram = "gonio";

// Adds everything to `app`; the commands in the order of the help.
std::vector<Command> add_commands(CLI::App& app);

// "gonio 0.1.0"
std::string program_version();

}  // namespace gonio::cli
