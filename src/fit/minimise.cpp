#include "fit/minimise.h"

#include <ceres/ceres.h>

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
  Eigen::MatrixXd R;
  Eigen::VectorXd r;
};

Compressed compress(const Eigen::MatrixXd& H, const Eigen::VectorXd& g) {
  const Eigen::VectorXd scale = H.diagonal().cwiseMax(1e-300).cwiseSqrt();
  const Eigen::VectorXd inverse = scale.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(inverse.asDiagonal() * H *
                                                             inverse.asDiagonal());
  const Eigen::VectorXd values = eigen.eigenvalues();
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

// The whole problem as one residual block over its free parameters.
class Block : public ceres::CostFunction {
 public:
  Block(const Problem& problem, std::span<const double> start, std::vector<std::size_t> free,
        const Stop& stop)
      : problem_(problem), all_(start.begin(), start.end()), free_(std::move(free)), stop_(stop) {
    set_num_residuals(static_cast<int>(free_.size()) + 1);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(free_.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    for (std::size_t i = 0; i < free_.size(); ++i) all_[free_[i]] = parameters[0][i];
    const auto n = static_cast<Eigen::Index>(free_.size());
    Eigen::Map<Eigen::VectorXd> r(residuals, n + 1);
    r.setZero();
    if (jacobians == nullptr || jacobians[0] == nullptr) {
      if (all_ != last_) cost_ = problem_.cost(all_, false, stop_), last_ = all_;
      r[n] = std::sqrt(2 * cost_);
      return std::isfinite(cost_);
    }
    const Equations e = problem_.equations(all_, stop_);
    cost_ = e.cost, last_ = all_;
    if (!std::isfinite(e.cost) || !e.matrix.allFinite()) return false;
    const Compressed small = compress(e.matrix(free_, free_), e.gradient(free_));
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> J(
        jacobians[0], n + 1, n);
    J.topRows(n) = small.R;
    J.row(n).setZero();
    r.head(n) = small.r;
    r[n] = std::sqrt(std::max(0.0, 2 * e.cost - small.r.squaredNorm()));
    return true;
  }

 private:
  const Problem& problem_;
  mutable std::vector<double> all_, last_;
  mutable double cost_ = 0;
  std::vector<std::size_t> free_;
  const Stop& stop_;
};

class Callback : public ceres::IterationCallback {
 public:
  explicit Callback(const MinimiseOptions& options) : options_(options) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (options_.progress) options_.progress(summary.iteration, summary.cost);
    const bool stopped = options_.stop && options_.stop();
    return stopped ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const MinimiseOptions& options_;
};

ceres::Solver::Options solver_options(const MinimiseOptions& options) {
  ceres::Solver::Options solver;
  solver.max_num_iterations = options.iterations;
  solver.function_tolerance = options.tolerance;
  solver.gradient_tolerance = 1e-12;
  solver.parameter_tolerance = 1e-9;
  solver.linear_solver_type = ceres::DENSE_QR;
  // A shorter step is tried where a bound cuts one; its length needs no gradients, which cost most.
  solver.line_search_interpolation_type = ceres::BISECTION;
  solver.num_threads = 1;
  solver.logging_type = ceres::SILENT;
  return solver;
}

}  // namespace

Bounds bounds_of(const Form& form, int channels) {
  Bounds bounds;
  for (const ShapeParameter& shape : form.shapes) {
    bounds.lower.push_back(shape.scale.to_search(shape.lower));
    bounds.upper.push_back(shape.scale.to_search(shape.upper));
  }
  for (int c = 0; c < channels; ++c) {
    for (const double upper : form.coefficient_upper) {
      bounds.lower.push_back(0);
      bounds.upper.push_back(upper);
    }
  }
  return bounds;
}

Minimum minimise(const Problem& problem, std::span<const double> start,
                 const MinimiseOptions& options) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (options.free.empty() || options.free[i]) free.push_back(i);
  }
  Minimum result{{start.begin(), start.end()}, 0, 0, true};
  if (free.empty()) return result;
  const Bounds bounds = bounds_of(problem.form(), problem.data().channels);
  std::vector<double> x;
  for (const std::size_t i : free)
    x.push_back(std::clamp(start[i], bounds.lower[i], bounds.upper[i]));
  ceres::Problem ceres_problem;
  ceres_problem.AddResidualBlock(new Block(problem, start, free, options.stop), nullptr, x.data());
  for (std::size_t i = 0; i < free.size(); ++i) {
    const int at = static_cast<int>(i);
    ceres_problem.SetParameterLowerBound(x.data(), at, bounds.lower[free[i]]);
    if (std::isfinite(bounds.upper[free[i]]))
      ceres_problem.SetParameterUpperBound(x.data(), at, bounds.upper[free[i]]);
  }
  Callback callback(options);
  ceres::Solver::Options solver = solver_options(options);
  solver.callbacks.push_back(&callback);
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &ceres_problem, &summary);
  for (std::size_t i = 0; i < free.size(); ++i) result.parameters[free[i]] = x[i];
  result.cost = summary.final_cost;
  result.iterations = static_cast<int>(summary.iterations.size());
  result.converged = summary.termination_type == ceres::CONVERGENCE;
  return result;
}

namespace {

// Holds what a bound holds at `x`: a step over all parameters that is cut there would be short and
// askew for the others.
std::vector<bool> not_held(const Problem& problem, std::span<const double> x,
                           const MinimiseOptions& options) {
  std::vector<bool> free = options.free;
  if (free.empty()) free.assign(x.size(), true);
  const Bounds bounds = bounds_of(problem.form(), problem.data().channels);
  const Equations e = problem.equations(x, options.stop);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double slope = e.gradient[static_cast<Eigen::Index>(i)];
    const bool held =
        (x[i] <= bounds.lower[i] && slope > 0) || (x[i] >= bounds.upper[i] && slope < 0);
    if (held) free[i] = false;
  }
  return free;
}

}  // namespace

Minimum minimise_by_stages(Problem& problem, std::span<const double> start,
                           std::span<const double> smooth_parts, const MinimiseOptions& options) {
  Minimum best{{start.begin(), start.end()}, 0, 0, true};
  for (const double part : smooth_parts) {
    if (options.stop && options.stop()) break;
    if (problem.loss().absolute())
      problem.set_smooth(
          std::max(part * problem.mean_residual(best.parameters, options.stop), 1e-12));
    MinimiseOptions stage = options;
    stage.free = not_held(problem, best.parameters, options);
    Minimum next = minimise(problem, best.parameters, stage);
    next.iterations += best.iterations;
    best = std::move(next);
    if (!problem.loss().absolute()) break;
  }
  return best;
}

}  // namespace gonio::fit
