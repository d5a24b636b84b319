// The bounds of the models' tables for the coefficients of one channel while the shapes are held,
// and least squares within them.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "fit/form.h"

namespace gonio::fit {

class CoefficientBounds {
 public:
  // `peaks`: what each column is divided by (basis.h).
  CoefficientBounds(const Form& form, std::span<const double> peaks);

  // Minimises x'Ax / 2 - b'x, A positive semidefinite: exactly, but for a diffuse term
  // that a reflectance takes light from; a descent goes on from there.
  [[nodiscard]] Eigen::VectorXd minimise(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) const;

 private:
  // Two coefficients whose sum is bounded: the amplitude of an affine reflectance.
  struct Sum {
    Eigen::Index first;
    double most;
  };
  // The second of a pair at its bound is `most` less the first.
  [[nodiscard]] Eigen::VectorXd with_tight(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                           const std::vector<Sum>& tight) const;
  [[nodiscard]] Eigen::VectorXd with_own_diffuse(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                                 double reflectance) const;

  std::vector<double> upper_;
  std::vector<Sum> sums_;
  bool own_diffuse_ = false;  // of Columns::affine_over_base
};

}  // namespace gonio::fit
