// A channel's reflectance as the sum of a form's columns, and its derivatives.
#pragma once

#include <Eigen/Core>
#include <span>

#include "fit/form.h"
#include "fit/linear/basis.h"

namespace gonio::fit {

// f of the first `count` pairs of `basis`.
void sum_columns(const Form& form, const Basis& basis, std::size_t count,
                 std::span<const double> coefficients, Eigen::ArrayXd& f);

// `slope` times df / d(shapes, then coefficients): a row a pair.
void derive_columns(const Form& form, const Basis& basis, std::size_t count,
                    std::span<const double> coefficients, const Eigen::ArrayXd& slope,
                    Eigen::MatrixXd& jacobian);

}  // namespace gonio::fit
