// What the object is made of, as the integrator asks for it: in whole runs, so that each question
// may be a call to the service. Thread safety: used by one thread.
#pragma once

#include <span>

#include "client/picture/image/image.h"
#include "gonio/base/result.h"

namespace gonio::render {

using image::Rgb;

// Directions are local, of unit length and interleaved xyz: `viewers` to the viewer, `lights` to
// where light comes from.
class Surface {
 public:
  virtual ~Surface() = default;
  // f in 1/sr of each pair, black where it cannot be evaluated; and, if there is room for it, the
  // density with which sample() would have drawn its light.
  virtual Outcome evaluate(std::span<const float> viewers, std::span<const float> lights,
                           std::span<Rgb> f, std::span<float> pdf) = 0;
  // Draws a light for each viewer, with three numbers in [0, 1) each; its density, and the weight
  // f cos / pdf. What is lost has pdf 0.
  virtual Outcome sample(std::span<const float> viewers, std::span<const float> xi,
                         std::span<float> lights, std::span<float> pdf, std::span<Rgb> weights) = 0;
};

}  // namespace gonio::render
