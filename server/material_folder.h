// A new file in the materials folder: it appears there as a whole or not at all, also if the
// machine fails in between, and never in the place of another. Thread safety: used by one thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "gonio/base/result.h"

namespace gonio {

// Whether files can be created in the folder.
bool can_be_written(const std::filesystem::path& folder);

// Removes what servers that were killed while they wrote have left behind, once it is a day old.
void remove_leftovers(const std::filesystem::path& folder);

class NewFile {
 public:
  // Writes `content` under a name that no material has. Errors: what the system says (internal;
  // resource_exhausted where the disk is full).
  static Result<NewFile> create(const std::filesystem::path& folder, std::string_view content);

  ~NewFile();  // without place() nothing is left behind
  NewFile(NewFile&& other) noexcept;
  NewFile& operator=(NewFile&& other) noexcept;

  // Gives it the name NAME.binary. Errors: already_exists if the folder has a file for a material
  // of that name.
  Outcome place(const std::string& name);

 private:
  NewFile(std::filesystem::path folder, std::filesystem::path temporary)
      : folder_(std::move(folder)), temporary_(std::move(temporary)) {}

  std::filesystem::path folder_;
  std::filesystem::path temporary_;  // empty: it has its place
};

}  // namespace gonio
