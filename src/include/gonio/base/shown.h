// Text that came from outside (a file, a request, a command line), made fit for a message, a log or
// a terminal. Thread safety: a function without state.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio {

// `text` in valid UTF-8 on one line, without anything that a terminal obeys or that hides or
// reorders what stands beside it:
//   line feed, carriage return, tab            \n \r \t
//   other control characters, bytes that are not UTF-8   \x1b
//   line separators, invisible and directional marks     \u{202e}
// A backslash stays as it is, so that shown(shown(t)) == shown(t). Text longer than `longest` bytes
// is cut between characters and ends in "...". Every error's field, value and message passes
// through here, and so does every line of a log.
std::string shown(std::string_view text, std::size_t longest = std::string_view::npos);

// What a message quotes of a value: enough to recognise it.
inline constexpr std::size_t kQuotedLength = 160;

}  // namespace gonio
