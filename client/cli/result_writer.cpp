#include "client/cli/result_writer.h"

namespace gonio::cli {

std::optional<Format> format_named(std::string_view name) {
  if (name == "csv") return Format::csv;
  if (name == "json") return Format::json;
  if (name == "npy") return Format::npy;
  return std::nullopt;
}

std::optional<Format> format_of_file(std::string_view file) {
  const std::size_t dot = file.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  return format_named(file.substr(dot + 1));
}

}  // namespace gonio::cli
