// Where samples become pixels. Thread safety: used by one thread.
#pragma once

#include <cstddef>
#include <utility>

#include "client/picture/image/image.h"

namespace gonio::render {

// Takes the samples pixel after pixel, so that one sum in double precision is enough for all of
// them.
class Film {
 public:
  Film(int width, int height, int samples) : image_(width, height), samples_(samples) {}

  void add(const image::Rgb& radiance);
  // After the last sample.
  image::Image take() { return std::move(image_); }

 private:
  image::Image image_;
  int samples_;  // of a pixel
  std::size_t pixel_ = 0;
  int taken_ = 0;
  Eigen::Array3d sum_ = Eigen::Array3d::Zero();
};

}  // namespace gonio::render
