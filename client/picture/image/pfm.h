// PFM, the portable float map: "PF" (RGB) or "Pf" (grey), width and height, a scale whose sign says
// the order of the bytes (negative: little endian), then float32 rows, the lower one first.
// Source: P. Debevec's "PFM Portable FloatMap Image Format", as Netpbm and pbrt write it.
// Thread safety: no state.
#pragma once

#include <string>

#include "client/picture/image/image.h"
#include "gonio/base/result.h"

namespace gonio::image {

// The scale's size is ignored, as everywhere. Errors: data_loss for what is truncated or no PFM
// file, invalid_argument for a picture beyond kMostTexels (read.h).
Result<Image> read_pfm(const std::string& file);

}  // namespace gonio::image
