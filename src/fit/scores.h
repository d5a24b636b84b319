// What robust standard errors are made of: curvature and scores, summed over pairs.
#pragma once

#include <Eigen/Core>

#include "fit/problem.h"

namespace gonio::fit {

struct Sandwich {
  Eigen::MatrixXd curvature;  // sum w loss''(e) J J'
  Eigen::MatrixXd scatter;    // sum over pairs of s s', s = sum over channels of w loss'(e) J
};

Sandwich sandwich_at(const Problem& problem, std::span<const double> parameters, const Stop& stop);

}  // namespace gonio::fit
