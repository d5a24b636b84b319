// A materials folder that a test fills.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "measured/temp_folder.h"
#include "server/server.h"

namespace gonio::server::testing {

inline void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

inline ServerOptions serving(const gonio::testing::TempFolder& folder) {
  ServerOptions options;
  options.materials = folder / "";
  return options;
}

}  // namespace gonio::server::testing
