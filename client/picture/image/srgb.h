// From linear light to the bytes that a screen shows. Thread safety: no state.
#pragma once

#include <cstdint>
#include <vector>

#include "client/picture/image/image.h"

namespace gonio::image {

// The transfer function of IEC 61966-2-1, of a value that is first brought into [0, 1]; NaN is 0.
float srgb_encoded(float linear);

// Eight bits a channel, interleaved RGB, row by row; the values times 2^exposure.
std::vector<std::uint8_t> srgb_bytes(const Image& image, double exposure);

}  // namespace gonio::image
