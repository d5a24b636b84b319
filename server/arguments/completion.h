// Completion of a program's command line by a shell, made from the program's own arguments, so that
// it cannot drift from them. Thread safety: functions without state.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::arguments {

// "bash", "fish", "zsh".
const std::vector<std::string>& shells();

// The script for one of shells(): commands, options, the words that options take, and files.
std::string completion_script(CLI::App& app, std::string_view shell);

}  // namespace gonio::arguments
