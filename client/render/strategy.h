// Ways to propose directions in which a point may receive light.
//
// The integrator asks every strategy for one direction per point, and divides by the sum of all
// strategies' densities there: the balance heuristic of Veach & Guibas 1995, Optimally Combining
// Sampling Techniques. It asks for whole runs of points, so that a strategy may be a call to the
// service: its sampling of the material from N directions is one more class here.
// Thread safety: const; called from several threads at once.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "client/render/light.h"

namespace gonio::render {

struct Point {
  Frame frame;
  Vec3f wo;  // to the viewer, local
};

class Strategy {
 public:
  virtual ~Strategy() = default;
  // One local direction a point, of unit length; below the horizon for none. All spans are of the
  // same length.
  [[nodiscard]] virtual Outcome propose(std::span<const Point> points, std::span<const Xi> xi,
                                        std::span<Vec3f> wi) const = 0;
  // The densities, in 1/sr, with which propose() draws these directions at these points.
  [[nodiscard]] virtual Outcome densities(std::span<const Point> points, std::span<const Vec3f> wi,
                                          std::span<double> density) const = 0;
};

// Those that suit the light, which must outlive them: its own directions, and for a light with many
// also the cosine-weighted hemisphere, which does better where a wide light is on a rough surface.
std::vector<std::unique_ptr<const Strategy>> strategies_for(const Light& light);

}  // namespace gonio::render
