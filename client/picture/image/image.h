// A picture of linear light. Thread safety: plain values.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace gonio::image {

// Red, green and blue of Rec. 709's primaries, linear in radiance.
using Rgb = Eigen::Array3f;

// The luminance of Rec. 709, ITU-R BT.709-6, item 3.2.
inline float luminance(const Rgb& colour) {
  return 0.2126F * colour[0] + 0.7152F * colour[1] + 0.0722F * colour[2];
}

struct Image {
  Image() = default;
  Image(int columns, int rows)
      : width(columns),
        height(rows),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), Rgb::Zero()) {}

  Rgb& at(int column, int row) { return pixels[index(column, row)]; }
  [[nodiscard]] const Rgb& at(int column, int row) const { return pixels[index(column, row)]; }

  int width = 0, height = 0;
  std::vector<Rgb> pixels;  // row by row, the upper one first

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
};

}  // namespace gonio::image
