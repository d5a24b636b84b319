// A density on the unit square, bilinear between nodes, and the map that draws from it.
// Thread safety: const after construction.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gonio {

class BilinearDensity {
 public:
  struct Place {
    double u, v;     // along a row and across the rows, in [0, 1]
    double density;  // there; it integrates to 1
  };

  // `values` [height][width] are finite and not negative; at least 2 by 2. The nodes stand at equal
  // distances from 0 to 1. Where all are 0 so is the density, and the map goes to its first cell.
  BilinearDensity(std::span<const float> values, std::size_t width, std::size_t height);

  // Where uniform numbers s and t in [0, 1] go: v by t, by the rows' own density, then u by s.
  [[nodiscard]] Place at(double s, double t) const;

 private:
  [[nodiscard]] double value(std::size_t row, std::size_t column) const {
    return values_[row * width_ + column];
  }

  std::span<const float> values_;
  std::size_t width_, height_;
  std::vector<double> along_;   // [height][width]: the integral of a row up to a column, in cells
  std::vector<double> across_;  // [height]: the integral of the rows' totals up to a row
};

}  // namespace gonio
