#include "client/cli/output/picture.h"

#include <optional>

#include "client/cli/input/file_kind.h"
#include "client/cli/output/numbers.h"

namespace gonio::cli {

Result<PictureSize> parse_size(const std::string& text, int least) {
  const auto cross = text.find('x');
  if (cross != std::string::npos) {
    const auto width = parse_number<int>(std::string_view(text).substr(0, cross));
    const auto height = parse_number<int>(std::string_view(text).substr(cross + 1));
    const auto allowed = [&](std::optional<int> side) {
      return side && *side >= least && *side <= kMostPixels;
    };
    if (allowed(width) && allowed(height)) return PictureSize{*width, *height};
  }
  return bad_value("--size", "\"" + text + "\"",
                   "WIDTHxHEIGHT, each from " + std::to_string(least) + " to " +
                       std::to_string(kMostPixels) + " pixels");
}

Result<PictureFormat> picture_format(const std::string& file) {
  const std::string extension = extension_of(file);
  if (extension == ".png") return PictureFormat::png;
  if (extension == ".exr") return PictureFormat::exr;
  return bad_value("-o", "\"" + file + "\"", "a file that ends in .png or .exr");
}

Outcome check_range(const std::string& option, double value, double lower, double upper) {
  if (value >= lower && value <= upper) return Ok{};
  return bad_value(option, shortest(value), shortest(lower) + " to " + shortest(upper));
}

}  // namespace gonio::cli
