// Levenberg and Marquardt's minimisation within bounds, by Ceres.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "fit/search/problem.h"

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

// From `start`, brought within the bounds of the models' tables; it ends within them. L1 by stages:
// the smoothing is each of these parts of the mean residual in turn. Other losses take one stage.
Minimum minimise_by_stages(Problem& problem, std::span<const double> start,
                           std::span<const double> smooth_parts, const MinimiseOptions& options);

}  // namespace gonio::fit
