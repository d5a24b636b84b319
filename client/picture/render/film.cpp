#include "client/picture/render/film.h"

namespace gonio::render {

void Film::add(const image::Rgb& radiance) {
  sum_ += radiance.cast<double>();
  if (++taken_ < samples_) return;
  image_.pixels[pixel_++] = (sum_ / samples_).cast<float>();
  sum_.setZero();
  taken_ = 0;
}

}  // namespace gonio::render
