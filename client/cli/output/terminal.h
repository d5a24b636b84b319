// The one way by which text for people reaches a terminal: file names, a server's words and a
// file's bytes among it can neither command the terminal nor pretend to be a line of their own.
// Thread safety: functions without state.
#pragma once

#include <string>
#include <string_view>

namespace gonio::cli {

// Text of several lines with each as shown() shows it (gonio/base/shown.h).
std::string shown_lines(std::string_view text);

// "gonio: <text>" on standard error, on one line.
void print_note(std::string_view text);
// "gonio: error: <text>" there.
void print_error(std::string_view text);
// Lines of text there.
void print_lines(std::string_view text);

}  // namespace gonio::cli
