#include "client/picture/render/camera.h"

#include <algorithm>
#include <cmath>

namespace gonio::render {
namespace {

constexpr double kMargin = 1.06;  // of the radius, for some air around the object

}  // namespace

Camera::Camera(const View& view, double radius, int width, int height)
    : width_(width), height_(height), orthographic_(view.field_of_view <= 0) {
  const double elevation = radians(view.elevation), half = radians(view.field_of_view) / 2;
  back_ = Vec3(0, -std::cos(elevation), std::sin(elevation));
  up_ = Vec3(0, std::sin(elevation), std::cos(elevation));
  const double reach = kMargin * radius;
  const double distance = orthographic_ ? 4 * reach : reach / std::sin(half);
  const double half_side = orthographic_ ? reach : distance * std::tan(half);
  position_ = distance * back_;
  pixel_ = 2 * half_side / (view.zoom * std::min(width_, height_));
}

Ray Camera::ray(double x, double y) const {
  const Vec3 on_plane =
      (x - width_ / 2) * pixel_ * Vec3::UnitX() + (height_ / 2 - y) * pixel_ * up_;
  if (orthographic_) return {position_ + on_plane, -back_};
  return {position_, (on_plane - position_).normalized()};
}

}  // namespace gonio::render
