#include "server/material_cache.h"

#include <utility>

namespace gonio {

std::optional<Material> MaterialCache::find(std::string_view bytes) {
  const std::lock_guard lock(mutex_);
  const auto found = young_.find(bytes);
  if (found != young_.end()) return found->second;
  const auto older = old_.find(bytes);
  if (older == old_.end()) return std::nullopt;
  return young_.insert(old_.extract(older)).position->second;
}

void MaterialCache::keep(std::string_view bytes, const Material& material) {
  if (bytes.size() > kMaxBytes || material.bytes() > kMaxMaterialBytes) return;
  const std::lock_guard lock(mutex_);
  if (young_.size() >= kGeneration) old_ = std::exchange(young_, {});
  young_.insert_or_assign(std::string(bytes), material);
}

}  // namespace gonio
