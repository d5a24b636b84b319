// What lights the object, from infinitely far away. Thread safety: const.
#pragma once

#include <memory>
#include <string>

#include "client/picture/image/image.h"
#include "client/picture/render/geometry.h"
#include "client/picture/render/sequence.h"
#include "gonio/base/result.h"

namespace gonio::render {

using image::Rgb;

// Directions are of unit length, in the world, and point to the light.
class Light {
 public:
  virtual ~Light() = default;

  // The radiance that comes from a direction. Of a light with a single direction: the irradiance on
  // a surface that faces it, whatever direction is asked for.
  [[nodiscard]] virtual Rgb radiance(const Vec3& direction) const = 0;
  // A direction, drawn with density() per steradian.
  [[nodiscard]] virtual Vec3 sample(const Xi& xi) const = 0;
  // Of a light with a single direction: 1, the probability of that one.
  [[nodiscard]] virtual double density(const Vec3& direction) const = 0;
  [[nodiscard]] virtual bool single_direction() const = 0;
};

// From `direction` (of unit length). A surface that faces it receives the irradiance pi, and if it
// is white and diffuse, has radiance 1.
std::unique_ptr<const Light> directional_light(const Vec3& direction);

// A whole sphere of radiance: a latitude-longitude map. Its upper edge is +z, its middle column +y
// (where the camera looks), and columns go on to the right as the camera sees it, towards +x. The
// radiance is constant in a texel, and directions are drawn in proportion to its luminance.
// Errors: a texel that is NaN, infinite or negative, named as in `name`: column and row from the
// upper left, from 0; a map without any light.
Result<std::unique_ptr<const Light>> dome_light(image::Image map, const std::string& name);

}  // namespace gonio::render
