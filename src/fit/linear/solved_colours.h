// The best coefficients for given shapes: what makes the many other parameters of a fit linear.
#pragma once

#include <span>
#include <vector>

#include "fit/search/problem.h"

namespace gonio::fit {

struct SolvedColours {
  std::vector<double> parameters;  // the shapes given, and the coefficients found
  double cost = 0;                 // of the exact objective
};

// For each channel, `passes` least squares problems, each solved exactly within the coefficients'
// bounds, with the weights that the last one's residuals ask for.
SolvedColours solve_colours(const Problem& problem, std::span<const double> shapes, int passes);

}  // namespace gonio::fit
