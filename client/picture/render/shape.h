// The object in the picture: one convex shape around the origin, met by rays in closed form. Thread
// safety: const.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "client/picture/render/geometry.h"

namespace gonio::render {

enum class ShapeKind : std::uint8_t { sphere, cylinder, plane };

class Shape {
 public:
  virtual ~Shape() = default;
  // The frame of the surface where the ray, which starts outside, first meets it from outside.
  [[nodiscard]] virtual std::optional<Frame> hit(const Ray& ray) const = 0;
  // Of the sphere around the origin that holds it.
  [[nodiscard]] virtual double radius() const = 0;
};

// sphere    radius 1, its poles up and down: u along the parallels to the east, v along the
//           meridians to the north (at the poles, u = (1,0,0))
// cylinder  lying, radius 0.6, length 1.8, its axis turned from +x by 20 degrees towards +y: on its
//           side u around it and v along its axis, on its ends u along the circles, as on a turned
//           part
// plane     the square [-1, 1] x [-1, 1] at z = 0, u = (1,0,0), v = (0,1,0); seen from above only
std::unique_ptr<const Shape> make_shape(ShapeKind kind);

}  // namespace gonio::render
