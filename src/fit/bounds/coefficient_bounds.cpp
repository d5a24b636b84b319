#include "fit/bounds/coefficient_bounds.h"

#include <algorithm>

#include "fit/linear/linear.h"

namespace gonio::fit {
namespace {

constexpr double kRounding = 1e-12;

double objective(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const Eigen::VectorXd& x) {
  return x.dot(0.5 * (A * x) - b);
}

// The minimum over x = M z + d.
Eigen::VectorXd minimise_along(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                               const Eigen::MatrixXd& M, const Eigen::VectorXd& d,
                               std::span<const double> upper) {
  return M * solve_bounded(M.transpose() * A * M, M.transpose() * (b - A * d), upper) + d;
}

}  // namespace

CoefficientBounds::CoefficientBounds(const Form& form, std::span<const double> peaks) {
  for (const FormLobe& lobe : form.lobes) {
    const Colour most = form.bounds_of(lobe).upper;
    const double height = peaks[lobe.first_column];
    if (is_diffuse(lobe.colours.columns)) {
      upper_.push_back(most.diffuse);
      continue;
    }
    if (lobe.coefficient_count > 1)
      sums_.push_back({static_cast<Eigen::Index>(upper_.size()), most.scale * height});
    upper_.resize(upper_.size() + std::min<std::size_t>(lobe.coefficient_count, 2),
                  most.scale * height);
    own_diffuse_ = lobe.coefficient_count > 2;
    if (own_diffuse_) upper_.push_back(most.diffuse);
  }
}

Eigen::VectorXd CoefficientBounds::with_tight(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                              const std::vector<Sum>& tight) const {
  const Eigen::Index n = b.size(), free = n - static_cast<Eigen::Index>(tight.size());
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, free);
  Eigen::VectorXd d = Eigen::VectorXd::Zero(n);
  std::vector<double> upper;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto pair = std::find_if(tight.begin(), tight.end(),
                                   [&](const Sum& sum) { return sum.first + 1 == i; });
    const auto column = static_cast<Eigen::Index>(upper.size());
    if (pair == tight.end()) {
      M(i, column) = 1;
      upper.push_back(upper_[static_cast<std::size_t>(i)]);
    } else {
      M(i, column - 1) = -1;
      d[i] = pair->most;
    }
  }
  return minimise_along(A, b, M, d, upper);
}

// Of the scale and the diffuse colour, with the reflectance held.
Eigen::VectorXd CoefficientBounds::with_own_diffuse(const Eigen::MatrixXd& A,
                                                    const Eigen::VectorXd& b,
                                                    double reflectance) const {
  Eigen::MatrixXd M(3, 2);
  M << reflectance, 0, 1 - reflectance, 0, 0, 1;
  const std::vector<double> upper{sums_[0].most, upper_[2] * (1 - reflectance)};
  return minimise_along(A, b, M, Eigen::VectorXd::Zero(3), upper);
}

Eigen::VectorXd CoefficientBounds::minimise(const Eigen::MatrixXd& A,
                                            const Eigen::VectorXd& b) const {
  Eigen::VectorXd x = solve_bounded(A, b, upper_);
  std::vector<Sum> tight;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const auto beyond = std::find_if(sums_.begin(), sums_.end(), [&](const Sum& sum) {
      return x[sum.first] + x[sum.first + 1] > sum.most * (1 + kRounding);
    });
    if (beyond == sums_.end()) break;
    tight.push_back(*beyond);
    x = with_tight(A, b, tight);
  }
  if (!own_diffuse_ || x[0] + x[1] <= 0) return x;
  const double reflectance = x[0] / (x[0] + x[1]);
  if (x[2] <= upper_[2] * (1 - reflectance)) return x;
  constexpr int kParts = 4;
  Eigen::VectorXd best = with_own_diffuse(A, b, 0);
  for (int part = 1; part <= kParts; ++part) {
    const Eigen::VectorXd next = with_own_diffuse(A, b, reflectance * part / kParts);
    if (objective(A, b, next) < objective(A, b, best)) best = next;
  }
  return best;
}

}  // namespace gonio::fit
