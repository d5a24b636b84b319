#include "client/picture/image/png.h"

#include <png.h>

namespace gonio::image {

Result<std::string> encode_png(std::span<const std::uint8_t> rgb, int width, int height) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(width);
  header.height = static_cast<png_uint_32>(height);
  header.format = PNG_FORMAT_RGB;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(header), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0) {
    return Error{
        ErrorCode::internal, std::string("no PNG could be made: ") + header.message, {}, {}, {}};
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace gonio::image
