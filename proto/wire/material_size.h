// The largest size of a request's material.
//
// A parsed material takes up to 70 times its bytes, more than anything else in a request. Thread
// safety: functions without state.
#pragma once

#include <cstddef>

#include "gonio/base/result.h"
#include "wire/codec.h"
#include "wire/fields.h"

namespace gonio::wire {

// The limit for the serialised gonio.v1.Material. A sensible one has at most a few kilobytes.
inline constexpr std::size_t kMaxMaterialBytes = std::size_t{256} << 10;

Outcome check_material_size(std::size_t bytes);

// The same for all the material that the generated parser would find in a message that is not in
// the canonical form. `Decoded` is one of codec.h's requests or chunks.
template <class Decoded>
Outcome check_material(const SliceBytes& bytes, Range range);

}  // namespace gonio::wire
