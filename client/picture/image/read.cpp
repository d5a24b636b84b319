#include "client/picture/image/read.h"

#include <filesystem>
#include <system_error>

#include "client/picture/image/exr.h"
#include "client/picture/image/pfm.h"
#include "gonio/base/shown.h"

namespace gonio::image {

Outcome check_size(const std::string& file, std::int64_t width, std::int64_t height) {
  // The division keeps a product that a hostile header asks for from overflowing.
  if (width >= 1 && height >= 1 && width <= kMostTexels / height) return Ok{};
  return bad_value(file, "a picture of " + std::to_string(width) + " x " + std::to_string(height),
                   "1 x 1 to " + std::to_string(kMostTexels) + " pixels in all");
}

Result<Image> read(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension();
  if (extension != ".exr" && extension != ".pfm") {
    return bad_value("the picture", "\"" + file + "\"", "a file that ends in .exr or .pfm");
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    return Error{ErrorCode::not_found, "no such file: " + shown(file), shown(file), {}, {}};
  }
  return extension == ".exr" ? read_exr(file) : read_pfm(file);
}

}  // namespace gonio::image
