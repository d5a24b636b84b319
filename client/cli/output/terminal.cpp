#include "client/cli/output/terminal.h"

#include <algorithm>
#include <cstdio>

#include "gonio/base/shown.h"

namespace gonio::cli {

std::string shown_lines(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines += shown(text.substr(0, end));
    if (end < text.size()) lines += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void print_note(std::string_view text) { std::fprintf(stderr, "gonio: %s\n", shown(text).c_str()); }

void print_error(std::string_view text) {
  std::fprintf(stderr, "gonio: error: %s\n", shown(text).c_str());
}

void print_lines(std::string_view text) { std::fputs(shown_lines(text).c_str(), stderr); }

}  // namespace gonio::cli
