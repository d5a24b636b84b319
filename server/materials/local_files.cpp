#include "server/materials/local_files.h"

#include <system_error>

namespace gonio::server {

std::optional<FileState> FileState::of(const std::filesystem::path& path) {
  std::error_code no_time, no_size;
  FileState state{path, std::filesystem::last_write_time(path, no_time),
                  std::filesystem::file_size(path, no_size)};
  if (no_time || no_size) return std::nullopt;
  return state;
}

std::optional<PreparedMaterial> LocalFiles::find(std::string_view bytes) {
  const std::lock_guard lock(mutex_);
  if (!latest_ || latest_->bytes != bytes || FileState::of(latest_->state.path) != latest_->state)
    return std::nullopt;
  return latest_->material;
}

void LocalFiles::keep(std::string_view bytes, const FileState& state,
                      const PreparedMaterial& material) {
  const std::lock_guard lock(mutex_);
  latest_.emplace(Entry{std::string(bytes), state, material});
}

}  // namespace gonio::server
