// What the commands that make pictures have in common. Thread safety: no state.
#pragma once

#include <cstdint>
#include <string>

#include "gonio/base/result.h"

namespace gonio::cli {

inline constexpr int kMostPixels = 8192;  // of a side

struct PictureSize {
  int width = 0, height = 0;
};

// "640x480". Errors name the text and what is allowed, from `least` to kMostPixels on each side.
Result<PictureSize> parse_size(const std::string& text, int least);

enum class PictureFormat : std::uint8_t { png, exr };

// By the file's extension.
Result<PictureFormat> picture_format(const std::string& file);

// Ok, or an error that names the option and its bounds, both of them allowed. NaN is outside.
Outcome check_range(const std::string& option, double value, double lower, double upper);

}  // namespace gonio::cli
