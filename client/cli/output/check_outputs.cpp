#include "client/cli/output/check_outputs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <system_error>

#include "base/near_names.h"
#include "base/text/join.h"
#include "client/cli/input/file_kind.h"

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

Outcome check_extension(const NamedFile& output, std::initializer_list<std::string_view> extensions,
                        const std::string& or_else) {
  const std::string extension = extension_of(output.file);
  if (output.file == "-" || extension.empty()) return Ok{};
  if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) return Ok{};
  std::error_code ignored;
  if (fs::exists(output.file, ignored) && !fs::is_regular_file(output.file, ignored)) return Ok{};
  std::vector<std::string> allowed(extensions.begin(), extensions.end());
  return bad_value(output.option, "\"" + output.file + "\"",
                   "a file that ends in " + joined(allowed, " or ") + or_else +
                       did_you_mean(extension, std::span<const std::string>(allowed)));
}

Outcome check_standard_input(const std::vector<NamedFile>& inputs) {
  const NamedFile* first = nullptr;
  for (const NamedFile& input : inputs) {
    if (input.file != "-") continue;
    if (first != nullptr)
      return bad_value(input.option, "-, which " + first->option + " reads", "a file");
    first = &input;
  }
  return Ok{};
}

}  // namespace gonio::cli
