// The materials that a server holds by name, and the way from a request's material to one that can
// be evaluated.
//
// Thread safety: immutable after load().
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "engine/material.h"
#include "gonio/v1/material.pb.h"
#include "server/build_material.h"

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

  // The material that a request asks for. Errors name the field as "material....".
  [[nodiscard]] Result<Material> resolve(const v1::Material& material) const;

 private:
  Outcome add(const std::filesystem::path& folder, const std::filesystem::path& file);

  std::map<std::string, Material, std::less<>> stored_;
  FindFile find_file_;
};

}  // namespace gonio
