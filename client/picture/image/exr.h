// OpenEXR: linear light as float32. Thread safety: no state.
#pragma once

#include <string>

#include "client/picture/image/image.h"
#include "gonio/base/result.h"

namespace gonio::image {

// The bytes of an OpenEXR file: channels R, G, B, float32, without loss (ZIP).
Result<std::string> encode_exr(const Image& image);

// Channels R, G and B, or Y alone; of several parts the first. Errors: data_loss for what is
// truncated or no OpenEXR file, invalid_argument for other channels, a cropped picture and one
// beyond kMostTexels (read.h).
Result<Image> read_exr(const std::string& file);

}  // namespace gonio::image
