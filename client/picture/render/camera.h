// Where the picture is taken from. Thread safety: const.
#pragma once

#include "client/picture/render/geometry.h"

namespace gonio::render {

struct View {
  double elevation = 20;      // degrees above the horizon, -90 to 90
  double field_of_view = 30;  // degrees across the picture's shorter side, 0 for orthographic
  double zoom = 1;            // the larger, the closer the part in the middle
};

// Stands in front of the origin, towards -y, and looks at it; +x is to the right. The sphere of
// `radius` around the origin just fits.
class Camera {
 public:
  Camera(const View& view, double radius, int width, int height);

  // Through a point of the picture, in pixels from its upper left corner.
  [[nodiscard]] Ray ray(double x, double y) const;

 private:
  Vec3 back_, up_, position_;
  double width_, height_;
  double pixel_;  // its size, on the plane through the origin that faces the camera
  bool orthographic_;
};

}  // namespace gonio::render
