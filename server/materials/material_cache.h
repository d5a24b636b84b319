// The materials of the latest requests, by their bytes.
//
// Many clients ask for one material again and again; taking its parameters apart and preparing them
// costs several times what evaluating one pair does. Thread safety: any thread.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/materials/prepared_material.h"

namespace gonio::server {

class MaterialCache {
 public:
  [[nodiscard]] std::optional<PreparedMaterial> find(std::string_view bytes);
  // Forgets the longest unused ones where there are too many, or they hold too much; large ones are
  // not kept at all.
  void keep(std::string_view bytes, const PreparedMaterial& material);

 private:
  static constexpr std::size_t kGeneration = 256;
  static constexpr std::size_t kMaxBytes = 4096;  // of a request's material
  static constexpr std::size_t kMaxMaterialBytes =
      64 << 10;  // of a prepared one; tables have a store of their own
  // Of a generation with the samplers that were made since its materials came.
  static constexpr std::size_t kMaxGenerationBytes = kGeneration * kMaxMaterialBytes;

  using Generation = std::map<std::string, PreparedMaterial, std::less<>>;
  static bool is_full(const Generation& generation);

  std::mutex mutex_;
  Generation young_, old_;  // what is found in the old one moves to the young one; a full young one
                            // becomes the old
};

}  // namespace gonio::server
