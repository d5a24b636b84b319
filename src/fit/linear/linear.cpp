#include "fit/linear/linear.h"

#include <Eigen/Cholesky>
#include <vector>

namespace gonio::fit {
namespace {

enum class At : std::uint8_t { lower, upper, free };

// The minimum over the free coefficients, the others held at their bounds.
Eigen::VectorXd with_held(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                          std::span<const double> upper, const std::vector<At>& at) {
  const Eigen::Index n = b.size();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto state = at[static_cast<std::size_t>(i)];
    if (state == At::upper) x[i] = upper[static_cast<std::size_t>(i)];
    if (state == At::free) free.push_back(i);
  }
  if (free.empty()) return x;
  const Eigen::VectorXd pull = b - A * x;
  const Eigen::VectorXd rest = pull(free);
  Eigen::MatrixXd square = A(free, free);
  // Columns that are nearly the same: the smallest ridge that keeps the solution finite.
  square.diagonal() *= 1 + 1e-13;
  const Eigen::VectorXd solution = square.ldlt().solve(rest);
  x(free) = solution;
  return x;
}

// The coefficient at a bound whose release gains most; -1 if none does.
Eigen::Index most_gaining(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                          const Eigen::VectorXd& x, const std::vector<At>& at) {
  const Eigen::VectorXd pull = b - A * x;
  Eigen::Index chosen = -1;
  double best = 1e-12;
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    const At state = at[static_cast<std::size_t>(i)];
    if (state == At::free || !(A(i, i) > 0)) continue;
    const double inward = state == At::lower ? pull[i] : -pull[i];
    const double gain =
        inward / std::sqrt(A(i, i) * (1e-300 + b.squaredNorm() / A.diagonal().maxCoeff()));
    if (gain > best) best = gain, chosen = i;
  }
  return chosen;
}

}  // namespace

// Block principal pivoting would be faster on many coefficients; these are few, and the primal
// method of Lawson & Hanson 1974, chapter 23, with upper bounds too, ends after about as many steps
// as there are coefficients.
Eigen::VectorXd solve_bounded(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                              std::span<const double> upper) {
  const Eigen::Index n = b.size();
  std::vector<At> at(static_cast<std::size_t>(n), At::lower);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  for (int step = 0; step < 16 * n; ++step) {
    const Eigen::Index chosen = most_gaining(A, b, x, at);
    if (chosen < 0) break;
    at[static_cast<std::size_t>(chosen)] = At::free;
    for (Eigen::Index inner = 0; inner <= n; ++inner) {
      const Eigen::VectorXd target = with_held(A, b, upper, at);
      // As far towards it as the bounds allow; the coefficient that stops there is held.
      double part = 1;
      Eigen::Index stopped = -1;
      for (Eigen::Index i = 0; i < n; ++i) {
        if (at[static_cast<std::size_t>(i)] != At::free) continue;
        const double limit = target[i] < 0 ? 0 : upper[static_cast<std::size_t>(i)];
        if (target[i] >= 0 && target[i] <= limit) continue;
        const double reach = (limit - x[i]) / (target[i] - x[i]);
        if (reach < part) part = std::max(reach, 0.0), stopped = i;
      }
      x += part * (target - x);
      if (stopped < 0) break;
      const bool low = target[stopped] < 0;
      x[stopped] = low ? 0 : upper[static_cast<std::size_t>(stopped)];
      at[static_cast<std::size_t>(stopped)] = low ? At::lower : At::upper;
    }
  }
  return x;
}

}  // namespace gonio::fit
