#include "client/cli/material_argument.h"

#include <google/protobuf/util/json_util.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "base/text/encoding.h"
#include "gonio/base/shown.h"
#include "gonio/engine/registry.h"
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
      "a server cannot read measured data from this machine; leave out --server, or put "
      "the file into goniod's --materials folder and give its name");
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

Result<Material> read_file(const std::string& file, bool embedded) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (!fs::exists(status)) {
    return Error{ErrorCode::not_found, "no such file: " + shown(file), "material", shown(file),
                 "inline JSON, a .json or MERL .binary file, or the name of a stored material"};
  }
  if (fs::is_directory(status)) return error_in(file, "is a folder, not a material");
  if (fs::path(file).extension() == ".binary") return measured(file, embedded);
  std::ifstream in(file, std::ios::binary);
  std::string json(kLongestJson + 1, '\0');
  in.read(json.data(), static_cast<std::streamsize>(json.size()));
  if (in.bad() || !in.is_open()) return error_in(file, "cannot be read");
  json.resize(static_cast<std::size_t>(in.gcount()));
  if (json.size() > kLongestJson)
    return error_in(file, "is longer than 1 MiB: not a material's JSON");
  return material_beside(json, fs::path(file).parent_path(), embedded, file);
}

// Without a server nothing is stored; a model's name is not yet a material.
Error nothing_stored(const std::string& name) {
  std::string allowed =
      "without --server: inline JSON such as '{\"model\": \"ggx\"}', or FILE.json";
  if (find_model(name)) allowed = "for this model: '{\"model\": \"" + name + "\"}'";
  Error error = bad_value("--material", "\"" + name + "\"", allowed, ErrorCode::not_found);
  error.message =
      "no material \"" + shown(name, kQuotedLength) + "\" is stored; allowed " + allowed;
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
  const std::string extension = fs::path(argument).extension();
  const bool file =
      extension == ".json" || extension == ".binary" || argument.find('/') != std::string::npos;
  if (file) return read_file(argument, embedded);
  if (embedded) return nothing_stored(argument);
  return Material::named(argument);
}

}  // namespace gonio::cli
