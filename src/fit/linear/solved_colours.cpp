#include "fit/linear/solved_colours.h"

#include <algorithm>
#include <cmath>

#include "fit/bounds/coefficient_bounds.h"
#include "fit/linear/arrays.h"

namespace gonio::fit {
namespace {

// |e| is reweighted by 1 / max(|e|, this part of its mean).
constexpr double kSmooth = 0.05;

bool is_quadratic(const FormLobe& lobe) {
  return lobe.colours.columns == Columns::quadratic_diffuse;
}

// One channel: columns (for the coefficients), measured values times cosine and their transform.
class Channel {
 public:
  Channel(const Problem& problem, const Basis& basis, int channel)
      : problem_(problem),
        n_(static_cast<Eigen::Index>(problem.data().size())),
        weight_(problem.weights().data(), n_),
        cosine_(problem.cosines().data(), n_),
        transformed_(problem.measured(channel).data(), n_),
        basis_(basis),
        values_(problem.data().channel(channel)) {
    predicted_.resize(n_);
    set_columns(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.form().coefficients)));
  }

  // The coefficients after `passes` solutions; `cost` gets what is added to the objective.
  Eigen::VectorXd solve(const CoefficientBounds& bounds, int passes, double& cost) {
    measured_ = Eigen::Map<const Eigen::ArrayXf>(values_.data(), n_).cast<double>() * cosine_;
    // A first guess between squares and their reverse: large values count, but do not rule.
    const double mean = (weight_ * measured_).sum() / weight_.sum();
    work_ = weight_ / (measured_ + (mean > 0 ? mean : 1));
    Eigen::VectorXd x;
    for (int pass = 0;; ++pass) {
      x = solve_squares(bounds);
      if (quadratic()) set_columns(x);
      predicted_ = columns_.col(0) * x[0];
      for (Eigen::Index k = 1; k < x.size(); ++k) predicted_ += columns_.col(k) * x[k];
      residual_ = difference();
      if (pass + 1 >= passes) break;
      reweigh();
    }
    cost += loss();
    return x;
  }

 private:
  [[nodiscard]] bool quadratic() const {
    const auto& lobes = problem_.form().lobes;
    return std::any_of(lobes.begin(), lobes.end(), &is_quadratic);
  }

  // The columns times the cosine; of a quadratic one, as if linear in a coefficient near its `x`.
  void set_columns(const Eigen::VectorXd& x) {
    const Form& form = problem_.form();
    columns_.resize(n_, static_cast<Eigen::Index>(form.coefficients));
    const auto column = [&](std::size_t k) {
      return Eigen::Map<const Eigen::ArrayXd>(&basis_.values[k * basis_.stride], n_);
    };
    for (const FormLobe& lobe : form.lobes) {
      for (std::size_t k = 0; k < lobe.coefficient_count; ++k) {
        const auto at = static_cast<Eigen::Index>(lobe.first_coefficient + k);
        auto to = columns_.col(at);
        to = column(lobe.first_column + k) * cosine_;
        if (is_quadratic(lobe)) to += x[at] * column(lobe.first_column + 1) * cosine_;
      }
    }
  }

  // Few long columns: products of one with one beat a general product, which would pack them first.
  Eigen::VectorXd solve_squares(const CoefficientBounds& bounds) {
    const Eigen::Index n = columns_.cols();
    Eigen::MatrixXd square(n, n);
    Eigen::VectorXd right(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      weighted_ = columns_.col(i) * work_;
      right[i] = weighted_.matrix().dot(measured_.matrix());
      for (Eigen::Index j = 0; j <= i; ++j)
        square(i, j) = square(j, i) = weighted_.matrix().dot(columns_.col(j).matrix());
    }
    return bounds.minimise(square, right);
  }

  [[nodiscard]] Eigen::ArrayXd difference() const {
    switch (problem_.loss().objective) {
      case Objective::log:
        return log_1p(predicted_) - transformed_;
      case Objective::cbrt:
        return cube_root(predicted_) - transformed_;
      default:
        return predicted_ - transformed_;
    }
  }

  // Least squares of (f - m) with these weights has nearly the loss's gradient: the transform is
  // taken as the chord between f and m.
  void reweigh() {
    const Loss& loss = problem_.loss();
    const double mean = (weight_ * residual_.abs()).sum() / weight_.sum();
    const double least = std::max(kSmooth * mean, 1e-300);
    if (loss.absolute()) {
      work_ = weight_ / residual_.abs().max(least);
    } else if (loss.objective == Objective::huber) {
      work_ = weight_ * (loss.threshold / residual_.abs().max(loss.threshold));
    } else {
      work_ = weight_;
    }
    if (loss.objective != Objective::log && loss.objective != Objective::cbrt) return;
    const Eigen::ArrayXd apart = predicted_ - measured_;
    const Eigen::ArrayXd chord = residual_.abs() / apart.abs().max(1e-300);
    work_ *= (apart.abs() > 1e-12).select(chord.square(), 1);
  }

  [[nodiscard]] double loss() const {
    const Loss& loss = problem_.loss();
    if (loss.absolute()) return (weight_ * residual_.abs()).sum();
    if (loss.objective != Objective::huber) return 0.5 * (weight_ * residual_.square()).sum();
    const Eigen::ArrayXd inner = residual_.abs().min(loss.threshold);
    return (weight_ * inner * (residual_.abs() - 0.5 * inner)).sum();
  }

  const Problem& problem_;
  Eigen::Index n_;
  Eigen::Map<const Eigen::ArrayXd> weight_, cosine_, transformed_;
  const Basis& basis_;
  std::span<const float> values_;
  Eigen::ArrayXXd columns_;
  Eigen::ArrayXd measured_, predicted_, residual_, work_, weighted_;
};

}  // namespace

SolvedColours solve_colours(const Problem& problem, std::span<const double> shapes, int passes) {
  Basis basis;
  const BasisAt at(problem.form(), shapes, false);
  at.evaluate(problem.data(), 0, problem.data().size(), basis);
  const CoefficientBounds bounds(problem.form(), at.peaks());
  SolvedColours solved{{shapes.begin(), shapes.end()}, 0};
  for (int c = 0; c < problem.data().channels; ++c) {
    const Eigen::VectorXd x = Channel(problem, basis, c).solve(bounds, passes, solved.cost);
    solved.parameters.insert(solved.parameters.end(), x.begin(), x.end());
  }
  return solved;
}

}  // namespace gonio::fit
