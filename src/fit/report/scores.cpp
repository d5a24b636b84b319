#include "fit/report/scores.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace gonio::fit {
namespace {

// The mean size of residuals among pairs whose predicted values are within a factor of 2: noise
// grows with what is measured, and the density at 0 is to be taken where it is alike.
class NoiseByLevel {
 public:
  void add(const PairRows& rows) {
    for (Eigen::Index i = 0; i < rows.residual.size(); ++i) {
      const std::size_t level = level_of(rows.predicted[i]);
      sums_[level] += std::abs(rows.residual[i]);
      counts_[level] += 1;
    }
  }
  // Half the width over which residuals count as 0: narrower where there are more (n^(-1/5)), but
  // no narrower than what rounding the data to float32 leaves.
  [[nodiscard]] double width(double predicted) const {
    const std::size_t level = level_of(predicted);
    const double mean = sums_[level] / std::max(counts_[level], 1.0);
    const double rounding = std::max(0x1p-24 * std::abs(predicted), 1e-300);
    return std::max(mean * std::pow(std::max(counts_[level], 1.0), -0.2), rounding);
  }

 private:
  static constexpr int kLevels = 96, kMiddle = 64;
  static std::size_t level_of(double predicted) {
    const int level = predicted > 0 ? std::ilogb(predicted) + kMiddle : 0;
    return static_cast<std::size_t>(std::clamp(level, 0, kLevels - 1));
  }
  std::array<double, kLevels> sums_{}, counts_{};
};

// loss''(e), of |e| as a kernel estimate: its second derivative is 2 at 0 and nothing elsewhere.
double curvature(const Loss& loss, double e, double width) {
  if (loss.absolute()) return std::abs(e) < width ? 1 / width : 0;
  if (loss.objective == Objective::huber) return std::abs(e) < loss.threshold ? 1 : 0;
  return 1;
}

// The rows of a channel among all parameters: the shapes' and its own.
std::vector<Eigen::Index> places_of(const Problem& problem, int channel) {
  const std::size_t shapes = problem.form().shapes.size(), own = problem.form().coefficients;
  std::vector<Eigen::Index> places(shapes + own);
  std::iota(places.begin(), places.end(), Eigen::Index{0});
  for (std::size_t k = shapes; k < places.size(); ++k)
    places[k] += static_cast<Eigen::Index>(own) * channel;
  return places;
}

Eigen::MatrixXd curvature_at(const Problem& problem, std::span<const double> parameters,
                             const Stop& stop) {
  NoiseByLevel noise;
  const Loss& loss = problem.loss();
  if (loss.absolute())
    problem.visit_rows(parameters, stop, [&](const PairRows& rows) { noise.add(rows); });
  const auto n = static_cast<Eigen::Index>(parameters.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
  problem.visit_rows(parameters, stop, [&](const PairRows& rows) {
    Eigen::ArrayXd curve = rows.weight;
    for (Eigen::Index i = 0; i < curve.size(); ++i)
      curve[i] *= curvature(loss, rows.residual[i], noise.width(rows.predicted[i]));
    const auto places = places_of(problem, rows.channel);
    sum(places, places) +=
        rows.jacobian.transpose() * (curve.matrix().asDiagonal() * rows.jacobian);
  });
  return sum;
}

// w loss'(e) of each pair, divided by 1 - h where the loss is smooth.
Eigen::ArrayXd scores_of(const PairRows& rows, const Loss& loss, const Eigen::MatrixXd& inverted) {
  constexpr double kMostLeverage = 0.9;
  Eigen::ArrayXd score = rows.weight;
  for (Eigen::Index i = 0; i < score.size(); ++i) {
    const double e = rows.residual[i];
    score[i] *= e == 0 ? 0 : e * loss.weight(e);
  }
  if (loss.absolute()) return score;
  const Eigen::ArrayXd leverage =
      rows.weight * (rows.jacobian * inverted).cwiseProduct(rows.jacobian).rowwise().sum().array();
  return score / (1 - leverage.min(kMostLeverage));
}

}  // namespace

Eigen::MatrixXd inverse(const Eigen::MatrixXd& H) {
  const Eigen::ArrayXd diagonal = H.diagonal();
  const Eigen::VectorXd scale = (diagonal > 1e-100).select(diagonal.max(1e-100).rsqrt(), 0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scale.asDiagonal() * H *
                                                             scale.asDiagonal());
  const Eigen::VectorXd values = eigen.eigenvalues().cwiseMax(1e-10).cwiseInverse();
  return scale.asDiagonal() * eigen.eigenvectors() * values.asDiagonal() *
         eigen.eigenvectors().transpose() * scale.asDiagonal();
}

Sandwich sandwich_at(const Problem& problem, std::span<const double> parameters, const Stop& stop) {
  const auto n = static_cast<Eigen::Index>(parameters.size());
  Sandwich sums{curvature_at(problem, parameters, stop), Eigen::MatrixXd::Zero(n, n)};
  if (!sums.curvature.allFinite()) return sums;
  const Eigen::MatrixXd inverted = inverse(sums.curvature);
  Eigen::MatrixXd scores;  // a row a pair, all channels together
  problem.visit_rows(parameters, stop, [&](const PairRows& rows) {
    if (rows.channel == 0) scores.setZero(rows.residual.size(), n);
    const auto places = places_of(problem, rows.channel);
    const Eigen::ArrayXd score = scores_of(rows, problem.loss(), inverted(places, places));
    scores(Eigen::all, places) += score.matrix().asDiagonal() * rows.jacobian;
    if (rows.channel + 1 == problem.data().channels) sums.scatter += scores.transpose() * scores;
  });
  return sums;
}

}  // namespace gonio::fit
