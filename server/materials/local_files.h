// The measured file of this machine that was last asked for, kept as long as it does not change.
//
// A picture asks for its material a hundred times; reading a table takes as long as evaluating a
// million pairs. Thread safety: any thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/materials/prepared_material.h"

namespace gonio::server {

// What of a file tells that it has changed.
struct FileState {
  std::filesystem::path path;
  std::filesystem::file_time_type written;
  std::uintmax_t size = 0;
  bool operator==(const FileState&) const = default;

  // None for what is no file.
  static std::optional<FileState> of(const std::filesystem::path& path);
};

class LocalFiles {
 public:
  // By the bytes of the request's material.
  [[nodiscard]] std::optional<PreparedMaterial> find(std::string_view bytes);
  // `state`: from before the file was read.
  void keep(std::string_view bytes, const FileState& state, const PreparedMaterial& material);

 private:
  struct Entry {
    std::string bytes;
    FileState state;
    PreparedMaterial material;
  };
  std::mutex mutex_;
  std::optional<Entry> latest_;
};

}  // namespace gonio::server
