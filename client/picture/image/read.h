// Reading pictures of linear light. Thread safety: no state.
#pragma once

#include <cstdint>
#include <string>

#include "client/picture/image/image.h"
#include "gonio/base/result.h"

namespace gonio::image {

inline constexpr std::int64_t kMostTexels = std::int64_t{1} << 25;  // 8192 x 4096: 400 MB

// By the file's extension: .exr or .pfm. Errors: not_found, another extension, and what the two
// readers say.
Result<Image> read(const std::string& file);

// Whether a picture of that size is taken. Errors name the file and the size.
Outcome check_size(const std::string& file, std::int64_t width, std::int64_t height);

}  // namespace gonio::image
