// A subdivision of the hemisphere of wo that follows a density, for quadrature and for bins.
//
// Its coordinates are those of the half-vector: its azimuth, and its colatitude as a fraction of
// the one at which wo meets the horizon. In them no lobe about a half-vector or about the mirror
// direction is too sharp, too long or too near to grazing, and the horizon is a straight edge. The
// first cells shrink geometrically towards the normal, towards the horizon, where the values of
// grazing light bend, and towards the azimuths along which lobes are long (the tangents' and those
// along and across wi); cells are then halved, along whichever coordinate changes more, until
// Gauss's rule agrees with itself. Smooth densities are integrated to 1e-5 and better; one that
// jumps within the hemisphere, as (wr.wo)^s all but does for s near 0, to 5e-3.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "numeric/direction.h"

namespace gonio::assess {

// A fixed number of columns for each of the directions (interleaved): the density, then others.
using Integrands = std::function<std::vector<double>(const std::vector<double>& wo)>;

struct Bin {
  double mass = 0, solid_angle = 0;
  Direction centre{};  // a direction inside
};

class Subdivision {
 public:
  // `tangents`: the azimuth of the material's u, in radians. No cell holds more than `largest` of
  // the density's mass. A density with many small jumps, such as a table's, needs small cells,
  // because the rule notices only jumps between its nodes.
  Subdivision(const Direction& wi, std::size_t columns, const Integrands& integrands,
              double tangents = 0, double largest = 1. / 64);

  [[nodiscard]] double integral(std::size_t column) const { return totals_[column]; }
  [[nodiscard]] double solid_angle() const { return totals_.back(); }
  // The sum of the absolute changes of the integral in the last halvings.
  [[nodiscard]] double change(std::size_t column) const { return changes_[column]; }
  // The integrals of other columns, by the same cells.
  [[nodiscard]] std::vector<double> integrals(std::size_t columns,
                                              const Integrands& integrands) const;

  // Merges neighbouring cells to bins, each with at least `least` of the density's mass.
  [[nodiscard]] std::vector<Bin> bins(double least);
  // The bin of each cell, after bins().
  [[nodiscard]] std::size_t bin_of(const Direction& wo) const;

 private:
  // [u0, u1] x [t0, t1], halved into `child` and the next one, or the leaf.
  struct Cell {
    double u0, u1, t0, t1;
    std::size_t child = 0;
    std::size_t bin = 0;
    bool across_u = false;
  };

  void lay_first_cells(double tangents);
  void refine(const Integrands& integrands);
  void settle(std::size_t cell, const std::vector<double>& halves, std::vector<std::size_t>& next);
  [[nodiscard]] std::array<Cell, 4> halves_of(const Cell& cell) const;
  void append_nodes(const Cell& cell, std::vector<double>& wo, std::vector<double>& weights) const;
  // `given` columns of each cell and its solid angle.
  [[nodiscard]] std::vector<double> integrate(const std::vector<Cell>& cells, std::size_t given,
                                              const Integrands& integrands) const;
  [[nodiscard]] double reach(double u) const;
  [[nodiscard]] Direction direction(double u, double t) const;
  void gather(std::size_t cell, double least, std::vector<Bin>& bins);

  Direction wi_;
  std::size_t columns_;  // with the solid angle as the last
  double largest_;
  std::vector<double> u_edges_, t_edges_;
  std::vector<Cell> cells_;
  std::vector<double> integrals_;  // columns_ of each cell
  std::vector<double> totals_, changes_, scales_;
};

}  // namespace gonio::assess
