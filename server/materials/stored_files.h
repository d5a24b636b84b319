// The files of a materials folder. Thread safety: functions without state.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/engine/material.h"

namespace gonio::server {

// The extensions of the files that are materials: a description as JSON, and a MERL table.
inline constexpr std::string_view kDescribed = ".json", kMeasured = ".binary";

// The files in `folder` that are materials, sorted. Errors: a folder that cannot be read.
Result<std::vector<std::filesystem::path>> material_files(const std::filesystem::path& folder);

// The material in a file of `folder`. Errors: what keeps it from being used.
Result<Material> load_file(const std::filesystem::path& folder, const std::filesystem::path& file);

Error unreadable(const std::filesystem::path& path, const std::string& why);

}  // namespace gonio::server
