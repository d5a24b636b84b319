#include "server/materials/materials.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/near_names.h"
#include "gonio/base/shown.h"
#include "gonio/engine/registry.h"
#include "gonio/measured/table.h"
#include "server/materials/preset_material.h"
#include "wire/convert.h"
#include "wire/material_size.h"

namespace gonio::server {
namespace {

namespace fs = std::filesystem;

Error unreadable(const fs::path& path, const std::string& why) {
  return {ErrorCode::not_found, path.string() + ": " + why, "", path.string(), ""};
}

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

Result<Material> load_file(const fs::path& folder, const fs::path& file) {
  std::error_code failure;
  if (!fs::is_regular_file(file, failure)) return unreadable(file, "it is not a readable file");
  if (file.extension() == ".json") return load_json(folder, file);
  auto table = MeasuredTable::read_merl(file);
  if (!table) return table.error();
  return Material::from_table(std::move(*table), Interpolation::linear);
}

// Protobuf strings are UTF-8, file names are any bytes.
bool can_be_sent(const std::string& name) {
  v1::Material message;
  message.set_name(name);
  return v1::Material().ParseFromString(message.SerializeAsString());
}

Result<std::vector<fs::path>> material_files(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const fs::path extension = entry->path().extension();
    if (extension == ".json" || extension == ".binary") files.push_back(entry->path());
  }
  if (failure)
    return unreadable(folder, "the materials folder cannot be read: " + failure.message());
  std::sort(files.begin(), files.end());
  return files;
}

// Whether nothing but a name is given.
bool is_named(const v1::Material& material) {
  return !material.name().empty() && material.model().empty() && !material.has_parameters() &&
         !material.has_diffuse() && material.specular_size() == 0;
}

Error no_such_material(const std::string& name, const std::vector<std::string>& stored) {
  std::string allowed = "a stored material, such as: " + near_names(name, stored);
  if (find_model(name)) {
    allowed += R"(; for the model: {"model": ")" + name + R"("})";
  } else {
    const std::vector<std::string> substances = preset_names();
    std::vector<std::string> known = stored;
    known.insert(known.end(), substances.begin(), substances.end());
    allowed += "; or a substance, such as: " + near_names(name, substances) +
               did_you_mean(name, std::span<const std::string>(known));
  }
  return bad_value("material.name", "\"" + name + "\"", allowed, ErrorCode::not_found);
}

}  // namespace

Outcome Materials::add(const fs::path& file) {
  const std::string name = file.stem().string();
  if (!can_be_sent(name)) return unreadable(file.filename(), "the file's name is not UTF-8");
  auto material = load_file(folder_, file);
  if (!material) return material.error();
  stored_.emplace(name, Stored{std::move(*material), std::nullopt, {}});
  return Ok{};
}

void Materials::skip(const fs::path& file, std::string reason) {
  std::error_code ignored;
  for (const fs::path& folder : {folder_, fs::weakly_canonical(folder_, ignored)}) {
    const std::string where = (folder / "").string();
    for (auto at = reason.find(where); at != std::string::npos; at = reason.find(where, at))
      reason.erase(at, where.size());
  }
  const std::string name = file.filename().string();
  if (reason.find(name) == std::string::npos) reason = name + ": " + reason;
  skipped_.push_back({shown(file.stem().string()), shown(reason)});
}

Result<Materials> Materials::load(const fs::path& folder) {
  const auto files = material_files(folder);
  if (!files) return files.error();
  Materials materials;
  materials.folder_ = folder;
  std::map<fs::path, int> files_of;  // by the material's name
  for (const fs::path& file : *files) ++files_of[file.stem()];
  for (const fs::path& file : *files) {
    const std::string name = file.stem().string();
    if (files_of[file.stem()] > 1) {
      materials.skip(file,
                     "there is another file for a material \"" + name + "\"; rename one of them");
    } else if (const auto added = materials.add(file); !added) {
      materials.skip(file, added.error().message);
    }
  }
  return materials;
}

void Materials::allow_local_files() {
  find_file_ = [](const std::string& file) -> Result<fs::path> { return fs::path(file); };
}

std::vector<std::string> Materials::names() const {
  const std::shared_lock lock(locks_->stored);
  std::vector<std::string> names;
  names.reserve(stored_.size());
  for (const auto& [name, stored] : stored_) names.push_back(name);
  return names;
}

bool Materials::holds(std::string_view name) const {
  const std::shared_lock lock(locks_->stored);
  return find(name) != nullptr;
}

Result<PreparedMaterial> Materials::resolve(const std::optional<std::string>& bytes) const {
  if (!bytes) return build({});
  if (auto known = cache_->find(*bytes)) return *known;
  if (auto known = local_files_->find(*bytes)) return *known;
  const auto fit = wire::check_material_size(bytes->size());
  if (!fit) return fit.error();
  v1::Material material;
  if (!material.ParseFromString(*bytes)) {
    return bad_value("material", "not a " + material.GetTypeName(), "the bytes of one");
  }
  if (find_file_ && is_measured(material)) return build_local(material, *bytes);
  if (const auto substance = substance_of(material)) {
    // Kept by what it is: a material may be stored under the name at any time.
    return resolve(substance->SerializeAsString());
  }
  auto built = build(material);
  if (built) cache_->keep(*bytes, *built);
  return built;
}

std::optional<v1::Material> Materials::substance_of(const v1::Material& material) const {
  // A file that cannot be used keeps its name: its error must not become another material.
  if (!is_named(material) || holds(material.name()) || find_skipped(material.name()) != nullptr)
    return std::nullopt;
  auto substance = preset_material(material.name());
  if (substance && material.has_rotation()) substance->set_rotation(material.rotation());
  return substance;
}

Result<PreparedMaterial> Materials::build(const v1::Material& material) const {
  if (!is_named(material)) {
    auto built = build_material(material, "material.", find_file_);
    if (!built) return built.error();
    return PreparedMaterial(std::move(*built));
  }
  const auto stored = find_copy(material.name());
  if (stored && !material.has_rotation()) return *stored;
  if (stored) {
    const auto rotation = check_rotation(material.rotation(), "material.");
    if (!rotation) return rotation.error();
    // One that turning does not change keeps its sampler.
    const Material& unturned = stored->material();
    if (!unturned.has_tangents() || material.rotation() == 0) return *stored;
    return PreparedMaterial(unturned.turned(material.rotation()));
  }
  return not_stored(material.name());
}

const Skipped* Materials::find_skipped(std::string_view name) const {
  const auto found = std::find_if(skipped_.begin(), skipped_.end(),
                                  [&](const Skipped& skipped) { return skipped.name == name; });
  return found == skipped_.end() ? nullptr : &*found;
}

Error Materials::not_stored(const std::string& name) const {
  if (const Skipped* skipped = find_skipped(name)) {
    return bad_value("material.name",
                     "\"" + name + "\", whose file the server cannot use (" + skipped->reason + ")",
                     "a stored material, or that file made right and the server started again",
                     ErrorCode::not_found);
  }
  return no_such_material(name, names());
}

Result<PreparedMaterial> Materials::build_local(const v1::Material& material,
                                                const std::string& bytes) const {
  const auto& fields = material.parameters().fields();
  const auto file = fields.find("file");
  const auto state =
      file == fields.end() ? std::nullopt : FileState::of(file->second.string_value());
  auto built = build(material);
  if (built && state) local_files_->keep(bytes, *state, *built);
  return built;
}

std::optional<PreparedMaterial> Materials::find_copy(std::string_view name) const {
  const std::shared_lock lock(locks_->stored);
  const Stored* stored = find(name);
  if (stored == nullptr) return std::nullopt;
  return stored->material;
}

const Materials::Stored* Materials::find(std::string_view name) const {
  const auto found = stored_.find(name);
  return found == stored_.end() ? nullptr : &found->second;
}

}  // namespace gonio::server
