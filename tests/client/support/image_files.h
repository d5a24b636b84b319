// Pictures as files, written and read by other means than the client's.
#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "client/picture/image/image.h"

namespace gonio::test {

struct Png {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  [[nodiscard]] const std::uint8_t* at(int x, int y) const { return &rgb[3U * (y * width + x)]; }
};

// As libpng reads it; of no size if it cannot.
inline Png decoded_png(const std::string& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  Png picture;
  if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) return picture;
  header.format = PNG_FORMAT_RGB;
  picture.rgb.resize(PNG_IMAGE_SIZE(header));
  if (png_image_finish_read(&header, nullptr, picture.rgb.data(), 0, nullptr) == 0) return {};
  picture.width = static_cast<int>(header.width);
  picture.height = static_cast<int>(header.height);
  return picture;
}

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void store(const std::filesystem::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

// A little-endian PFM file's bytes.
inline std::string pfm_of(const image::Image& picture) {
  std::string bytes =
      "PF\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n-1.0\n";
  for (int y = picture.height - 1; y >= 0; --y) {
    for (int x = 0; x < picture.width; ++x) {
      const image::Rgb& pixel = picture.at(x, y);
      bytes.append(reinterpret_cast<const char*>(pixel.data()), sizeof(image::Rgb));
    }
  }
  return bytes;
}

}  // namespace gonio::test
