// A new file in the materials folder: it appears there as a whole or not at all, also if the
// machine fails in between, and never in the place of another. Thread safety: used by one thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "gonio/base/result.h"

namespace gonio::server {

// Whether files can be created in the folder.
bool can_be_written(const std::filesystem::path& folder);

// Removes what servers that were killed while they wrote have left behind; says how many files.
// Several servers may share a folder: what a living one writes is locked (flock) and stays. Over
// NFS that holds as far as its locks do.
std::size_t remove_leftovers(const std::filesystem::path& folder);

// An open file, closed at the end; below 0: none.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

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
  NewFile(std::filesystem::path folder, std::filesystem::path temporary, Descriptor locked)
      : folder_(std::move(folder)), temporary_(std::move(temporary)), locked_(std::move(locked)) {}

  std::filesystem::path folder_;
  std::filesystem::path temporary_;  // empty: it has its place
  Descriptor locked_;                // of the file, as long as it is temporary
};

}  // namespace gonio::server
