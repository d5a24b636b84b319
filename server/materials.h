// The materials that a server holds by name, and the way from a request's material to one that can
// be evaluated.
//
// Thread safety: after load() and allow_local_files(), any thread.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "engine/material.h"
#include "gonio/v1/material.pb.h"
#include "server/build_material.h"
#include "server/material_cache.h"

namespace gonio {

class Materials {
 public:
  Materials() = default;

  // Every *.json (see material.proto; also {"model": "measured", "parameters": {"file": "x.binary",
  // "interpolation": "nearest"}}, the file within `folder`) and every MERL *.binary of `folder`,
  // each under its name without the extension. Errors: a folder that cannot be read; a file that
  // cannot be used, or two of one name, by name.
  static Result<Materials> load(const std::filesystem::path& folder);

  // Lets resolve() read files of this machine.
  void allow_local_files();

  [[nodiscard]] std::vector<std::string> names() const;  // sorted

  // The material that a request asks for, by the serialised gonio.v1.Material in it (none if it has
  // none). Errors name the field as "material....".
  [[nodiscard]] Result<PreparedMaterial> resolve(const std::optional<std::string>& bytes) const;

 private:
  [[nodiscard]] Result<PreparedMaterial> build(const v1::Material& material) const;
  Outcome add(const std::filesystem::path& folder, const std::filesystem::path& file);

  std::map<std::string, PreparedMaterial, std::less<>> stored_;
  FindFile find_file_;
  // Stored materials never change, so that their names can be kept as well; files of this machine
  // may change.
  std::unique_ptr<MaterialCache> cache_ = std::make_unique<MaterialCache>();
};

}  // namespace gonio
