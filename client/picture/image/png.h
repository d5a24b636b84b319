// PNG, through libpng. Thread safety: no state.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "gonio/base/result.h"

namespace gonio::image {

// The bytes of a PNG file that says of itself that it is sRGB. `rgb`: 3 x width x height bytes, row
// by row, the upper one first. Errors: what libpng says.
Result<std::string> encode_png(std::span<const std::uint8_t> rgb, int width, int height);

}  // namespace gonio::image
