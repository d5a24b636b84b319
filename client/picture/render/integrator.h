// From a scene to a picture: direct light on one object. Thread safety: no state.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "client/picture/render/camera.h"
#include "client/picture/render/light.h"
#include "client/picture/render/shape.h"
#include "client/picture/render/surface.h"
#include "gonio/base/result.h"

namespace gonio::render {

struct Scene {
  const Shape& shape;
  const Camera& camera;
  const Light& light;
  std::optional<Rgb> background;  // a radiance; without one, that of the light is seen
};

// Where the directions that are looked at come from: the light, the surface, or both, weighed by
// the balance heuristic of Veach & Guibas 1995, "Optimally Combining Sampling Techniques". Of a
// light with a single direction, only the light.
enum class Technique : std::uint8_t { both, light, surface };

struct Sampling {
  int width = 1, height = 1;
  int samples = 1;  // of a pixel
  std::uint32_t seed = 0;
  Technique technique = Technique::both;
  int threads = 0;  // for what is not the service's work; 0 for one a processor
};

// Called with the share of the picture that is done, 0 to 1.
using OnProgress = std::function<void(double)>;

// The radiance of every pixel, the mean over its square. The same scene, seed and service give the
// same bits, however many threads there are. Memory: the picture, and some 40 MB. Errors: what the
// service says.
Result<image::Image> render(const Scene& scene, const Sampling& sampling, Surface& surface,
                            const OnProgress& on_progress);

}  // namespace gonio::render
