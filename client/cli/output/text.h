// Laying out text for people. Thread safety: no state.
#pragma once

#include <string>
#include <string_view>

namespace gonio::cli {

// A cell of a table, as shown() shows its text; at least one space follows.
std::string padded(std::string_view text, std::size_t width);

// Breaks `words`, as shown() shows them, into lines that start at column `indent`; the first one is
// already there.
std::string wrapped(std::string_view words, std::size_t indent);

}  // namespace gonio::cli
