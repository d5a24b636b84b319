#include "fit/search/problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/linear/array_kernels.h"
#include "fit/linear/columns.h"

namespace gonio::fit {
// One channel's pairs of a tile: reflectance, residuals, and the weighted Jacobian's rows.
struct Problem::Rows {
  Eigen::ArrayXd f, residual, slope, root;  // root: of the least-squares weight
  Eigen::MatrixXd jacobian;                 // times root
  Eigen::VectorXd weighted;                 // the residual times root
};

Problem::Problem(const Form& form, const Data& data, Loss loss, bool cosine)
    : form_(form), data_(data), loss_(loss) {
  const std::size_t n = data.size();
  weights_.assign(data.weights.begin(), data.weights.end());
  cosines_.assign(n, 1);
  if (cosine) std::copy(data.wi[2].begin(), data.wi[2].end(), cosines_.begin());
  measured_.resize(n * static_cast<std::size_t>(data.channels));
  double total = 0;
  for (int c = 0; c < data.channels; ++c) {
    const auto values = data.channel(c);
    for (std::size_t i = 0; i < n; ++i) {
      const double value = static_cast<double>(values[i]) * cosines_[i];
      const double m = loss_.transformed(value);
      mean_measured_ += weights_[i] * value;
      measured_[static_cast<std::size_t>(c) * n + i] = m;
      total += weights_[i] * loss_.loss(m);
    }
  }
  weight_sum_ = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  mean_measured_ /= weight_sum_ * data.channels;
  const double unit = total > 0 ? total : weight_sum_;
  for (double& w : weights_) w /= unit;
  weight_sum_ /= unit;
}

template <class Visit>
void Problem::visit(std::span<const double> parameters, bool derivatives, const Stop& stop,
                    const Visit& visit_tile) const {
  const BasisAt at(form_, parameters.first(form_.shapes.size()), derivatives);
  Basis basis;
  for (std::size_t first = 0; first < data_.size(); first += kTile) {
    if (stop && stop()) return;
    const std::size_t count = std::min(kTile, data_.size() - first);
    at.evaluate(data_, first, count, basis);
    for (int c = 0; c < data_.channels; ++c) {
      const auto offset = form_.shapes.size() + form_.coefficients * static_cast<std::size_t>(c);
      visit_tile(basis, Tile{first, count}, c, parameters.subspan(offset, form_.coefficients));
    }
  }
}

// Fills residual, slope and root, and returns the weighted sum of losses.
double Problem::residuals(Tile tile, int channel, const Loss& loss, Rows& rows) const {
  const auto n = static_cast<Eigen::Index>(tile.count);
  for (Eigen::ArrayXd* result : {&rows.residual, &rows.slope, &rows.root}) result->resize(n);
  const ResidualRun run{tile.count,
                        rows.f.data(),
                        &cosines_[tile.first],
                        &weights_[tile.first],
                        &measured(channel)[tile.first],
                        loss.smooth,
                        loss.threshold,
                        rows.residual.data(),
                        rows.slope.data(),
                        rows.root.data()};
  return array_kernels().residuals[static_cast<std::size_t>(loss.objective)](run);
}

// A channel's rows touch the shapes and its own coefficients only.
void Problem::add(const Rows& rows, int channel, Equations& to) const {
  const auto shapes = static_cast<Eigen::Index>(form_.shapes.size());
  const auto own = static_cast<Eigen::Index>(form_.coefficients);
  const Eigen::Index n = shapes + own;
  Eigen::MatrixXd square(n, n);
  Eigen::VectorXd slope(n);
  // Few long columns: dot products beat a general product, which would pack them first.
  for (Eigen::Index i = 0; i < n; ++i) {
    slope[i] = rows.jacobian.col(i).dot(rows.weighted);
    for (Eigen::Index j = 0; j <= i; ++j)
      square(i, j) = square(j, i) = rows.jacobian.col(i).dot(rows.jacobian.col(j));
  }
  const Eigen::Index at = shapes + own * channel;
  to.matrix.topLeftCorner(shapes, shapes) += square.topLeftCorner(shapes, shapes);
  to.matrix.block(0, at, shapes, own) += square.topRightCorner(shapes, own);
  to.matrix.block(at, 0, own, shapes) += square.bottomLeftCorner(own, shapes);
  to.matrix.block(at, at, own, own) += square.bottomRightCorner(own, own);
  to.gradient.head(shapes) += slope.head(shapes);
  to.gradient.segment(at, own) += slope.tail(own);
}

double Problem::cost(std::span<const double> parameters, bool exact, const Stop& stop) const {
  Loss loss = loss_;
  if (exact) loss.smooth = 0;
  Rows rows;
  double sum = 0;
  visit(parameters, false, stop,
        [&](const Basis& basis, Tile tile, int c, std::span<const double> coefficients) {
          sum_columns(form_, basis, tile.count, coefficients, rows.f);
          sum += residuals(tile, c, loss, rows);
        });
  return sum;
}

void Problem::visit_rows(std::span<const double> parameters, const Stop& stop,
                         const std::function<void(const PairRows&)>& visitor) const {
  Rows rows;
  PairRows given;
  visit(parameters, true, stop,
        [&](const Basis& basis, Tile tile, int c, std::span<const double> coefficients) {
          const auto n = static_cast<Eigen::Index>(tile.count);
          sum_columns(form_, basis, tile.count, coefficients, rows.f);
          residuals(tile, c, loss_, rows);
          rows.root.setOnes(n);
          rows.slope *= rows.root;
          derive_columns(form_, basis, tile.count, coefficients, rows.slope, rows.jacobian);
          given.first = tile.first;
          given.channel = c;
          given.weight = Eigen::Map<const Eigen::ArrayXd>(&weights_[tile.first], n);
          given.predicted = rows.f * Eigen::Map<const Eigen::ArrayXd>(&cosines_[tile.first], n);
          given.residual = rows.residual;
          given.jacobian = rows.jacobian;
          visitor(given);
        });
}

double Problem::mean_residual(std::span<const double> parameters, const Stop& stop) const {
  Loss loss = loss_;
  Rows rows;
  double sum = 0;
  visit(parameters, false, stop,
        [&](const Basis& basis, Tile tile, int c, std::span<const double> coefficients) {
          sum_columns(form_, basis, tile.count, coefficients, rows.f);
          residuals(tile, c, loss, rows);
          const Eigen::Map<const Eigen::ArrayXd> weight(&weights_[tile.first],
                                                        static_cast<Eigen::Index>(tile.count));
          sum += (weight * rows.residual.abs()).sum();
        });
  return sum / (weight_sum_ * data_.channels);
}

Equations Problem::equations(std::span<const double> parameters, const Stop& stop) const {
  const auto n = static_cast<Eigen::Index>(this->parameters());
  Equations result{0, Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Zero(n, n)};
  Rows rows;
  visit(parameters, true, stop,
        [&](const Basis& basis, Tile tile, int c, std::span<const double> coefficients) {
          sum_columns(form_, basis, tile.count, coefficients, rows.f);
          result.cost += residuals(tile, c, loss_, rows);
          rows.slope *= rows.root;
          derive_columns(form_, basis, tile.count, coefficients, rows.slope, rows.jacobian);
          rows.weighted = (rows.residual * rows.root).matrix();
          add(rows, c, result);
        });
  return result;
}

}  // namespace gonio::fit
