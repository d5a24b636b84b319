#include "client/cli/output/text.h"

#include <algorithm>

#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

constexpr std::size_t kPageWidth = 96;

}  // namespace

std::string padded(std::string_view text, std::size_t width) {
  std::string result = shown(text);
  result.resize(std::max(result.size() + 1, width), ' ');
  return result;
}

std::string wrapped(std::string_view words, std::size_t indent) {
  const std::string line = shown(words);
  std::string_view text = line;
  std::string result;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column > indent && column + 1 + end > kPageWidth) {
      result += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result += text.substr(0, end);
    column += end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace gonio::cli
