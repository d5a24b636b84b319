// A problem as Ceres sees it.
//
// One block of as many residuals as there are parameters, and one more: a factor R of the normal
// matrix (R'R = J'WJ), the residuals that have the same gradient, and what is left of the cost.
// Ceres takes the very steps that it would take on the whole, and neither it nor we ever hold the
// Jacobian of a million pairs.
#pragma once

#include <ceres/cost_function.h>

#include <span>
#include <vector>

#include "fit/bounds/coordinates.h"
#include "fit/search/problem.h"

namespace gonio::fit {

// The equations at `at`, by these coordinates.
Equations equations_at(const Problem& problem, const Coordinates& coordinates,
                       std::span<const double> at, const Stop& stop);

// Over the coordinates `free`, the others as in `start`.
class EquationsBlock : public ceres::CostFunction {
 public:
  // `begin`: the equations at `start`. Problem, coordinates and stop must outlive this.
  EquationsBlock(const Problem& problem, const Coordinates& coordinates,
                 std::span<const double> start, Equations begin, std::vector<std::size_t> free,
                 const Stop& stop);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  const Problem& problem_;
  const Coordinates& coordinates_;
  mutable std::vector<double> all_, last_, tried_;
  mutable Equations equations_;  // at last_
  mutable double cost_ = 0;      // at tried_
  std::vector<std::size_t> free_;
  const Stop& stop_;
};

}  // namespace gonio::fit
