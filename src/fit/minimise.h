// Levenberg and Marquardt's minimisation within bounds, by Ceres.
#pragma once

#include <span>
#include <vector>

#include "fit/problem.h"

namespace gonio::fit {

struct MinimiseOptions {
  int iterations = 50;
  double tolerance = 1e-7;  // relative change of the cost
  // Which parameters move; empty: all.
  std::vector<bool> free;
  // Told of each iteration: its number and the cost.
  std::function<void(int, double)> progress;
  Stop stop;
};

struct Minimum {
  std::vector<double> parameters;
  double cost = 0;  // as smoothed
  int iterations = 0;
  bool converged = false;
};

// The bounds of all parameters of a problem: shapes in search scale, then coefficients.
struct Bounds {
  std::vector<double> lower, upper;
};
Bounds bounds_of(const Form& form, int channels);

// From `start`, brought within the bounds. L1 by stages: the smoothing is each of these parts of
// the mean residual in turn. Other losses take one stage.
Minimum minimise_by_stages(Problem& problem, std::span<const double> start,
                           std::span<const double> smooth_parts, const MinimiseOptions& options);

}  // namespace gonio::fit
