#include "client/cli/check_outputs.h"

#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

namespace gonio::cli {
namespace {

namespace fs = std::filesystem;

// By which two names of one place are equal; none for a device or a pipe.
std::optional<std::string> place_of(const std::string& file) {
  if (file == "-") return file;
  std::error_code ignored;
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)) return {};
  return fs::weakly_canonical(fs::absolute(file, ignored), ignored).string();
}

Error taken(const NamedFile& output, const std::string& by, const std::string& allowed) {
  return bad_value(output.option, "\"" + output.file + "\", as " + by + " is", allowed);
}

}  // namespace

Outcome check_outputs(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs) {
  std::map<std::string, std::string> read, written;  // options by places
  for (const NamedFile& input : inputs) {
    std::error_code ignored;
    const bool there = input.file != "-" && fs::exists(input.file, ignored);
    if (const auto place = there ? place_of(input.file) : std::nullopt)
      read.emplace(*place, input.option);
  }
  for (const NamedFile& output : outputs) {
    const auto place = output.file.empty() ? std::nullopt : place_of(output.file);
    if (!place) continue;
    if (const auto found = read.find(*place); found != read.end())
      return taken(output, found->second, "a file that is not read");
    const auto [other, is_new] = written.emplace(*place, output.option);
    if (!is_new) return taken(output, other->second, "another place");
  }
  return Ok{};
}

}  // namespace gonio::cli
