#include "server/materials/stored_files.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "gonio/measured/table.h"
#include "server/materials/build_material.h"
#include "wire/convert.h"

namespace gonio::server {
namespace {

namespace fs = std::filesystem;

Result<std::string> read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()))
    return Error{ErrorCode::data_loss, "it is empty or cannot be read", "", "", ""};
  return std::move(text).str();
}

// A stored material names files relative to its folder, and none outside: whoever may add a
// material file need not be one who may read every file of the machine.
FindFile files_within(const fs::path& folder) {
  return [folder](const std::string& file) -> Result<fs::path> {
    std::error_code no_root, no_path;
    const fs::path root = fs::weakly_canonical(folder, no_root);
    const fs::path path = fs::weakly_canonical(root / file, no_path);
    const auto [end, unused] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    if (!no_root && !no_path && end == root.end() && path != root) return path;
    return bad_value("parameters.file", "\"" + file + "\"", "a file within the materials folder");
  };
}

Result<Material> load_json(const fs::path& folder, const fs::path& file) {
  const auto text = read_text(file);
  if (!text) return text.error();
  const auto material = wire::material_from_json(*text);
  if (!material) return material.error();
  if (!material->name().empty()) {
    return bad_value("name", "\"" + material->name() + "\"",
                     "a model or a sum: a stored material has its file's name");
  }
  return build_material(*material, "", files_within(folder));
}

}  // namespace

Error unreadable(const fs::path& path, const std::string& why) {
  return {ErrorCode::not_found, path.string() + ": " + why, "", path.string(), ""};
}

Result<std::vector<fs::path>> material_files(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const fs::path extension = entry->path().extension();
    if (extension == kDescribed || extension == kMeasured) files.push_back(entry->path());
  }
  if (failure)
    return unreadable(folder, "the materials folder cannot be read: " + failure.message());
  std::sort(files.begin(), files.end());
  return files;
}

Result<Material> load_file(const fs::path& folder, const fs::path& file) {
  std::error_code failure;
  if (!fs::is_regular_file(file, failure)) return unreadable(file, "it is not a readable file");
  if (file.extension() == kDescribed) return load_json(folder, file);
  auto table = MeasuredTable::read_merl(file);
  if (!table) return table.error();
  return Material::from_table(std::move(*table), Interpolation::linear);
}

}  // namespace gonio::server
