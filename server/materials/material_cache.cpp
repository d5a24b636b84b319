#include "server/materials/material_cache.h"

#include <utility>

namespace gonio::server {

std::optional<PreparedMaterial> MaterialCache::find(std::string_view bytes) {
  const std::lock_guard lock(mutex_);
  const auto found = young_.find(bytes);
  if (found != young_.end()) return found->second;
  const auto older = old_.find(bytes);
  if (older == old_.end()) return std::nullopt;
  return young_.insert(old_.extract(older)).position->second;
}

bool MaterialCache::is_full(const Generation& generation) {
  std::size_t bytes = 0;
  for (const auto& [key, material] : generation) bytes += material.bytes();
  return generation.size() >= kGeneration || bytes >= kMaxGenerationBytes;
}

void MaterialCache::keep(std::string_view bytes, const PreparedMaterial& material) {
  if (bytes.size() > kMaxBytes || material.bytes() > kMaxMaterialBytes) return;
  const std::lock_guard lock(mutex_);
  if (is_full(young_)) old_ = std::exchange(young_, {});
  young_.insert_or_assign(std::string(bytes), material);
}

}  // namespace gonio::server
