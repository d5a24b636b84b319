#include "fit/search/minimise.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

#include "fit/bounds/coordinates.h"
#include "fit/linear/equations_block.h"

namespace gonio::fit {
namespace {

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

// Which coordinates move: not those that a bound holds at `x`, where the gradient is `slope`. A
// step over all that is cut there would be short and askew for the others.
std::vector<std::size_t> moving(std::span<const double> x, const Eigen::VectorXd& slope,
                                const Bounds& bounds, const std::vector<bool>& free) {
  std::vector<std::size_t> moves;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double outward = slope[static_cast<Eigen::Index>(i)];
    const bool held =
        (x[i] <= bounds.lower[i] && outward > 0) || (x[i] >= bounds.upper[i] && outward < 0);
    if (!held && (free.empty() || free[i])) moves.push_back(i);
  }
  return moves;
}

// From a start inside the bounds; only those of the coordinates hold.
Minimum descend(const Problem& problem, const Coordinates& coordinates,
                std::span<const double> start, const MinimiseOptions& options) {
  Minimum result{{start.begin(), start.end()}, 0, 0, true};
  std::vector<double> all = coordinates.from_parameters(start);
  const Bounds bounds = coordinates.bounds();
  Equations begin = equations_at(problem, coordinates, all, options.stop);
  result.cost = begin.cost;
  const auto free = moving(all, begin.gradient, bounds, options.free);
  if (free.empty()) return result;
  std::vector<double> x;
  for (const std::size_t i : free) x.push_back(all[i]);
  ceres::Problem ceres_problem;
  ceres_problem.AddResidualBlock(
      new EquationsBlock(problem, coordinates, all, std::move(begin), free, options.stop), nullptr,
      x.data());
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
  for (std::size_t i = 0; i < free.size(); ++i) all[free[i]] = x[i];
  result.parameters = coordinates.to_parameters(all);
  result.cost = summary.final_cost;
  result.iterations = static_cast<int>(summary.iterations.size());
  result.converged = summary.termination_type == ceres::CONVERGENCE;
  return result;
}

// A descent that ends beyond a bound starts again by coordinates that have it.
Minimum minimise(const Problem& problem, std::span<const double> from,
                 const MinimiseOptions& options) {
  // Of a bound: a start so near to it has met it.
  constexpr double kNear = 0.999;
  const int channels = problem.data().channels;
  const std::vector<double> start = within_bounds(problem.form(), from, channels);
  Coordinates coordinates(problem.form(), channels);
  coordinates.follow(start, kNear);
  int iterations = 0;
  for (;;) {
    Minimum end = descend(problem, coordinates, start, options);
    end.iterations += iterations;
    if (!coordinates.follow(end.parameters, 1)) return end;
    iterations = end.iterations;
  }
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
    Minimum next = minimise(problem, best.parameters, options);
    next.iterations += best.iterations;
    best = std::move(next);
    if (!problem.loss().absolute()) break;
  }
  return best;
}

}  // namespace gonio::fit
