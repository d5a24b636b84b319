// What robust standard errors are made of: curvature and scores, summed over pairs.
#pragma once

#include <Eigen/Core>

#include "fit/search/problem.h"

namespace gonio::fit {

// The inverse of a positive semidefinite matrix; directions that it does not see get the variance
// of the least that rounding lets it see, parameters without any curvature 0.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& H);

// Where the loss is smooth, a pair's scores are divided by 1 - h, h its leverage: the part of its
// residual that the fit took away by following it (MacKinnon & White 1985, HC3). Without, intervals
// are too narrow where few pairs carry much weight.
struct Sandwich {
  Eigen::MatrixXd curvature;  // sum w loss''(e) J J'
  Eigen::MatrixXd scatter;    // sum over pairs of s s', s = sum over channels of w loss'(e) J
};

Sandwich sandwich_at(const Problem& problem, std::span<const double> parameters, const Stop& stop);

}  // namespace gonio::fit
