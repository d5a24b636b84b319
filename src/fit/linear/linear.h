// The coefficients of one channel for given columns: weighted least squares, not negative, and
// reweighted for what is not least squares.
#pragma once

#include <Eigen/Core>
#include <span>

namespace gonio::fit {

// Minimises x'Ax / 2 - b'x over 0 <= x <= upper, exactly. A is positive semidefinite and small (at
// most 8 rows).
Eigen::VectorXd solve_bounded(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                              std::span<const double> upper);

}  // namespace gonio::fit
