#include "fit/scores.h"

#include <algorithm>
#include <array>
#include <cmath>

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
  // Half the width over which residuals count as 0: narrower where there are more (n^(-1/5)).
  [[nodiscard]] double width(double predicted) const {
    const std::size_t level = level_of(predicted);
    const double mean = sums_[level] / std::max(counts_[level], 1.0);
    return std::max(mean * std::pow(std::max(counts_[level], 1.0), -0.2), 1e-300);
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

}  // namespace

Sandwich sandwich_at(const Problem& problem, std::span<const double> parameters, const Stop& stop) {
  NoiseByLevel noise;
  if (problem.loss().absolute())
    problem.visit_rows(parameters, stop, [&](const PairRows& rows) { noise.add(rows); });
  const auto n = static_cast<Eigen::Index>(parameters.size());
  const auto shapes = static_cast<Eigen::Index>(problem.form().shapes.size());
  const auto own = static_cast<Eigen::Index>(problem.form().coefficients);
  Sandwich sums{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  Eigen::MatrixXd scores;  // a row a pair, all channels together
  const Loss& loss = problem.loss();
  problem.visit_rows(parameters, stop, [&](const PairRows& rows) {
    const Eigen::Index count = rows.residual.size(), at = shapes + own * rows.channel;
    if (rows.channel == 0) scores.setZero(count, n);
    Eigen::ArrayXd score(count), curve(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const double e = rows.residual[i];
      score[i] = rows.weight[i] * (e == 0 ? 0 : e * loss.weight(e));
      curve[i] = rows.weight[i] * curvature(loss, e, noise.width(rows.predicted[i]));
    }
    const Eigen::MatrixXd weighted = curve.matrix().asDiagonal() * rows.jacobian;
    const Eigen::MatrixXd square = rows.jacobian.transpose() * weighted;
    sums.curvature.topLeftCorner(shapes, shapes) += square.topLeftCorner(shapes, shapes);
    sums.curvature.block(0, at, shapes, own) += square.topRightCorner(shapes, own);
    sums.curvature.block(at, 0, own, shapes) += square.bottomLeftCorner(own, shapes);
    sums.curvature.block(at, at, own, own) += square.bottomRightCorner(own, own);
    scores.leftCols(shapes) += score.matrix().asDiagonal() * rows.jacobian.leftCols(shapes);
    scores.middleCols(at, own) += score.matrix().asDiagonal() * rows.jacobian.rightCols(own);
    if (rows.channel + 1 == problem.data().channels) sums.scatter += scores.transpose() * scores;
  });
  return sums;
}

}  // namespace gonio::fit
