// What a tile's input is brought into, one for each thread, so that no tile allocates.
#pragma once

#include <cstddef>
#include <memory>

#include "gonio/engine/evaluate.h"

namespace gonio::server {

template <class T>
struct TileScratch {
  alignas(64) T wi[3 * kTilePairs];
  alignas(64) T other[3 * kTilePairs];  // wo or xi

  static TileScratch& of_this_thread() {
    thread_local const auto scratch = std::make_unique<TileScratch>();
    return *scratch;
  }
};

}  // namespace gonio::server
