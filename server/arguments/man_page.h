// Manual pages from the help. Thread safety: functions without state.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gonio::arguments {

// A page for man(1), as roff: of a program, or of a command of it. `program`: the name before the
// command's, empty for a program. `version`: "gonio 0.1.0".
std::string man_page(const CLI::App& app, const std::string& program, const std::string& version);

// "gonio-evaluate.1".
std::string man_page_name(const CLI::App& app, const std::string& program);

}  // namespace gonio::arguments
