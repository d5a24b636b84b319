// The parts of the picture of a lobe. Thread safety: used by one thread.
#pragma once

#include "client/picture/lobe/canvas.h"
#include "client/picture/lobe/lobe.h"
#include "client/picture/lobe/scale.h"

namespace gonio::lobe {

// How large things are, all from one radius.
struct Style {
  double radius;  // of the half disc, and of the hemisphere
  [[nodiscard]] double text() const { return radius / 12; }
  [[nodiscard]] double line() const { return radius / 90; }
};

inline constexpr Colour kInk{0.13, 0.13, 0.16};
inline constexpr Colour kFaint{0.80, 0.80, 0.83};
inline constexpr Colour kLight{0.90, 0.50, 0.05};  // the incident ray

// The curve over a half disc whose centre is `centre`; light comes from the left. `channels`: 1 for
// one line, 3 for red, green and blue ones.
void draw_polar(Canvas& canvas, Spot centre, const Style& style, const Scale& scale,
                const Incidence& incidence, const Curve& curve, int channels);

// The hemisphere in false colours of luminance; `pixels` as hemisphere_of() gives them, its side
// twice the radius in whole pixels. Marks the light, the mirror's direction and the tangents.
void draw_hemisphere(Canvas& canvas, Spot centre, const Style& style, const Scale& scale,
                     const Incidence& incidence, int side, std::span<const image::Rgb> pixels);

// The colours' scale, upright, from `bottom` up.
void draw_bar(Canvas& canvas, Spot bottom, double height, const Style& style, const Scale& scale);

}  // namespace gonio::lobe
