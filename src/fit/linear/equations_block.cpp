#include "fit/linear/equations_block.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace gonio::fit {
namespace {

// Eigenvalues below this part of the largest (of the matrix scaled to a unit diagonal) are
// rounding.
constexpr double kNull = 1e-14;

// R and r with R'R = H and R'r = g on H's range.
struct Compressed {
  Eigen::MatrixXd factor;     // R
  Eigen::VectorXd residuals;  // r
};

Compressed compress(const Eigen::MatrixXd& H, const Eigen::VectorXd& g) {
  const Eigen::VectorXd scale = H.diagonal().cwiseMax(1e-300).cwiseSqrt();
  const Eigen::VectorXd inverse = scale.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(inverse.asDiagonal() * H *
                                                             inverse.asDiagonal());
  const Eigen::VectorXd& values = eigen.eigenvalues();
  const double least = kNull * std::max(values.maxCoeff(), 1e-300);
  Eigen::VectorXd root = values.cwiseMax(0).cwiseSqrt(), inverse_root = root;
  for (Eigen::Index i = 0; i < root.size(); ++i) {
    const bool null = !(values[i] > least);
    if (null) root[i] = 0;
    inverse_root[i] = null ? 0 : 1 / root[i];
  }
  const Eigen::MatrixXd turned = eigen.eigenvectors().transpose();
  return {root.asDiagonal() * turned * scale.asDiagonal(),
          inverse_root.asDiagonal() * (turned * (inverse.asDiagonal() * g))};
}

}  // namespace

Equations equations_at(const Problem& problem, const Coordinates& coordinates,
                       std::span<const double> at, const Stop& stop) {
  Equations e = problem.equations(coordinates.to_parameters(at), stop);
  if (coordinates.plain()) return e;
  const Eigen::MatrixXd slopes = coordinates.slopes(at);
  e.gradient = slopes.transpose() * e.gradient;
  e.matrix = slopes.transpose() * e.matrix * slopes;
  return e;
}

EquationsBlock::EquationsBlock(const Problem& problem, const Coordinates& coordinates,
                               std::span<const double> start, Equations begin,
                               std::vector<std::size_t> free, const Stop& stop)
    : problem_(problem),
      coordinates_(coordinates),
      all_(start.begin(), start.end()),
      last_(all_),
      equations_(std::move(begin)),
      free_(std::move(free)),
      stop_(stop) {
  set_num_residuals(static_cast<int>(free_.size()) + 1);
  mutable_parameter_block_sizes()->push_back(static_cast<int>(free_.size()));
}

bool EquationsBlock::Evaluate(double const* const* parameters, double* residuals,
                              double** jacobians) const {
  for (std::size_t i = 0; i < free_.size(); ++i) all_[free_[i]] = parameters[0][i];
  const auto n = static_cast<Eigen::Index>(free_.size());
  Eigen::Map<Eigen::VectorXd> r(residuals, n + 1);
  r.setZero();
  if (jacobians == nullptr || jacobians[0] == nullptr) {
    if (all_ != tried_)
      cost_ = problem_.cost(coordinates_.to_parameters(all_), false, stop_), tried_ = all_;
    r[n] = std::sqrt(2 * cost_);
    return std::isfinite(cost_);
  }
  if (all_ != last_) equations_ = equations_at(problem_, coordinates_, all_, stop_), last_ = all_;
  const Equations& e = equations_;
  cost_ = e.cost, tried_ = all_;
  if (!std::isfinite(e.cost) || !e.matrix.allFinite()) return false;
  const Compressed small = compress(e.matrix(free_, free_), e.gradient(free_));
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> J(jacobians[0],
                                                                                       n + 1, n);
  J.topRows(n) = small.factor;
  J.row(n).setZero();
  r.head(n) = small.residuals;
  r[n] = std::sqrt(std::max(0.0, 2 * e.cost - small.residuals.squaredNorm()));
  return true;
}

}  // namespace gonio::fit
