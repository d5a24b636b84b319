#include "measured/bilinear_density.h"

#include <algorithm>
#include <cmath>

namespace gonio {
namespace {

// Where the integral of a density that goes linearly from a at 0 to b at 1 reaches `mass`: the root
// of a x + (b - a) x^2 / 2 = mass in the form that does not cancel.
double place_of(double mass, double a, double b) {
  const double root = std::sqrt(std::max(a * a + 2 * mass * (b - a), 0.0));
  return a + root > 0 ? std::clamp(2 * mass / (a + root), 0.0, 1.0) : 0;
}

double mix(double a, double b, double part) { return a + part * (b - a); }

// The last of `count` cells that begins at or below `mass`; `begin` of a cell rises with it.
template <class Begin>
std::size_t cell_of(double mass, std::size_t count, const Begin& begin) {
  std::size_t low = 0, high = count;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (begin(middle) <= mass ? low : high) = middle;
  }
  return low;
}

}  // namespace

BilinearDensity::BilinearDensity(std::span<const float> values, std::size_t width,
                                 std::size_t height)
    : values_(values),
      width_(width),
      height_(height),
      along_(width * height, 0.0),
      across_(height, 0.0) {
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t i = 1; i < width; ++i)
      along_[row * width + i] =
          along_[row * width + i - 1] + (value(row, i - 1) + value(row, i)) / 2;
  }
  for (std::size_t row = 1; row < height; ++row)
    across_[row] = across_[row - 1] + (along_[row * width - 1] + along_[(row + 1) * width - 1]) / 2;
}

BilinearDensity::Place BilinearDensity::at(double s, double t) const {
  const double mass = t * across_.back();
  const std::size_t row = cell_of(mass, height_ - 1, [&](std::size_t r) { return across_[r]; });
  const double below = along_[(row + 1) * width_ - 1], above = along_[(row + 2) * width_ - 1];
  const double v = place_of(mass - across_[row], below, above);
  const auto begin = [&](std::size_t i) {
    return mix(along_[row * width_ + i], along_[(row + 1) * width_ + i], v);
  };
  const double own = s * mix(below, above, v);
  const std::size_t column = cell_of(own, width_ - 1, begin);
  const double left = mix(value(row, column), value(row + 1, column), v);
  const double right = mix(value(row, column + 1), value(row + 1, column + 1), v);
  const double u = place_of(own - begin(column), left, right);
  const auto columns = static_cast<double>(width_ - 1), rows = static_cast<double>(height_ - 1);
  const double unit = across_.back() > 0 ? columns * rows / across_.back() : 0;
  return {(static_cast<double>(column) + u) / columns, (static_cast<double>(row) + v) / rows,
          mix(left, right, u) * unit};
}

}  // namespace gonio
