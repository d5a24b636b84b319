#include "client/cli/arguments/material_argument.h"

#include <google/protobuf/util/json_util.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "base/near_names.h"
#include "base/text/encoding.h"
#include "client/cli/input/file_kind.h"
#include "gonio/base/shown.h"
#include "gonio/engine/registry.h"
#include "server/materials/preset_material.h"
#include "wire/convert.h"

namespace gonio::cli {
namespace {

namespace fs = std::filesystem;
using client::Material;

constexpr std::size_t kLongestJson = std::size_t{1} << 20;

Error error_in(const std::string& file, const std::string& what) {
  return {ErrorCode::invalid_argument, shown(file) + ": " + what, "material", shown(file), {}};
}

Error only_embedded(const std::string& file) {
  return error_in(
      file,
      "a server cannot read measured data from this machine; leave out --server, or store the file "
      "on the server ('gonio put NAME FILE') and give its name");
}

// The path itself where there is no current folder to start from.
std::string absolute_path(const fs::path& path) {
  std::error_code failure;
  const fs::path found = fs::absolute(path, failure);
  return failure ? path.string() : found.string();
}

// A measured material's file lies beside the JSON that names it, as in goniod's --materials folder.
Result<Material> material_beside(const std::string& json, const fs::path& folder, bool embedded,
                                 const std::string& origin) {
  auto message = wire::material_from_json(json);
  if (!message) return error_in(origin, message.error().message);
  auto& fields = *message->mutable_parameters()->mutable_fields();
  const auto file = fields.find("file");
  // What is no name is left as it is, for the server to say what is wrong with it.
  if (message->model() == "measured" && file != fields.end() && file->second.has_string_value()) {
    const std::string name = file->second.string_value();
    if (!embedded) return only_embedded(name);
    if (!name.empty()) file->second.set_string_value(absolute_path(folder / name));
  }
  if (fields.empty()) message->clear_parameters();
  std::string resolved;
  const auto status = google::protobuf::util::MessageToJsonString(*message, &resolved);
  if (!status.ok()) return error_in(origin, shown(status.ToString()));
  return Material::from_json(resolved);
}

Result<Material> measured(const std::string& file, bool embedded) {
  if (!embedded) return only_embedded(file);
  return Material::model("measured", {{"file", absolute_path(file)}});
}

bool exists(const std::string& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

Result<Material> json_from(std::istream& in, const fs::path& folder, bool embedded,
                           const std::string& origin) {
  std::string json(kLongestJson + 1, '\0');
  in.read(json.data(), static_cast<std::streamsize>(json.size()));
  if (in.bad()) return error_in(origin, "cannot be read");
  json.resize(static_cast<std::size_t>(in.gcount()));
  if (json.size() > kLongestJson)
    return error_in(origin, "is longer than 1 MiB: not a material's JSON");
  return material_beside(json, folder, embedded, origin);
}

// What the file holds says how it is read, not its name; a MERL file that is none says so itself.
Result<Material> read_file(const std::string& file, bool embedded) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (!fs::exists(status)) {
    return Error{ErrorCode::not_found, "no such file: " + shown(file) + near_files(file),
                 "material", shown(file),
                 "inline JSON, a .json or MERL .binary file, or the name of a stored material"};
  }
  if (fs::is_directory(status)) return error_in(file, "is a folder, not a material");
  const FileKind kind = kind_of_file(file).value_or(FileKind::unknown);
  const bool named_so = extension_of(file) == ".binary";
  if (kind == FileKind::merl || (kind == FileKind::unknown && named_so))
    return measured(file, embedded);
  if (kind != FileKind::material_json && kind != FileKind::other_json && kind != FileKind::unknown)
    return wrong_kind("--material", file, kind, "a material");
  std::ifstream in(file, std::ios::binary);
  if (!in.is_open()) return error_in(file, "cannot be read");
  return json_from(in, fs::path(file).parent_path(), embedded, file);
}

// By its name, or because it is there and is a material, or cannot be the name of anything else.
bool is_file(const std::string& argument) {
  const std::string extension = extension_of(argument);
  if (extension == ".json" || extension == ".binary") return true;
  if (argument.find('/') != std::string::npos) return true;
  const auto kind = kind_of_file(argument);
  return kind && (!extension.empty() || kind == FileKind::material_json || kind == FileKind::merl);
}

// Without a server nothing is stored; a model's name is not yet a material.
Error nothing_stored(const std::string& name) {
  std::string allowed =
      "without --server: inline JSON such as '{\"model\": \"ggx\"}', FILE.json, or a substance "
      "('gonio models --presets')";
  if (find_model(name)) allowed = "for this model: '{\"model\": \"" + name + "\"}'";
  std::vector<std::string> known = server::preset_names();
  for (const ModelDescription& model : models()) known.emplace_back(model.name);
  std::string hint = did_you_mean(name, std::span<const std::string>(known));
  if (hint.empty() || fs::path(name).has_extension()) hint = near_files(name);
  Error error = bad_value("--material", "\"" + name + "\"", allowed, ErrorCode::not_found);
  error.message =
      "no material \"" + shown(name, kQuotedLength) + "\" is stored; allowed " + allowed + hint;
  return error;
}

}  // namespace

Result<Material> read_material(const std::string& argument, bool embedded) {
  const auto plain = utf8_text(argument, "--material");
  if (!plain) return plain.error();
  const auto start = plain->find_first_not_of(" \t\r\n");
  if (start == std::string::npos) {
    return bad_value("--material", "empty",
                     "inline JSON, a file, or the name of a stored material");
  }
  if ((*plain)[start] == '{') return material_beside(argument, {}, embedded, "--material");
  if (argument == "-") return json_from(std::cin, {}, embedded, "standard input");
  // As curl and others mean it.
  if (argument[0] == '@' && !exists(argument)) return read_file(argument.substr(1), embedded);
  if (is_file(argument)) return read_file(argument, embedded);
  if (embedded && !server::preset_material(argument)) return nothing_stored(argument);
  return Material::named(argument);
}

}  // namespace gonio::cli
