// The objective of one form on one set of data, as a function of all parameters: the shapes in
// search scale, then each channel's coefficients.
//
// Sums run over tiles of fixed size in the order of the pairs: results do not depend on threads.
// Weights are normalised so that the objective of f = 0 is about 1, or less.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "fit/data/data.h"
#include "fit/form.h"
#include "fit/linear/basis.h"
#include "fit/linear/objective.h"

namespace gonio::fit {

// Asked before every tile; true ends all work soon.
using Stop = std::function<bool()>;

// Gauss and Newton's equations at a point: the cost, its gradient and the matrix J' W J.
struct Equations {
  double cost = 0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd matrix;
};

// One channel's pairs of a tile, for sums that a fit does not need but its certificate does.
struct PairRows {
  std::size_t first = 0;  // of the pairs
  int channel = 0;
  Eigen::ArrayXd weight;
  Eigen::ArrayXd predicted, residual;  // f cos, e
  Eigen::MatrixXd jacobian;            // de / d(shapes, then the channel's coefficients)
};

class Problem {
 public:
  // Both must outlive this. `cosine`: whether a residual is of f cos, or of f.
  Problem(const Form& form, const Data& data, Loss loss, bool cosine);

  void set_smooth(double smooth) { loss_.smooth = smooth; }
  [[nodiscard]] const Loss& loss() const { return loss_; }
  [[nodiscard]] const Form& form() const { return form_; }
  [[nodiscard]] const Data& data() const { return data_; }
  [[nodiscard]] std::size_t parameters() const { return form_.parameters(data_.channels); }

  // The weighted sum of losses; that of their exact form, not smoothed, if `exact`.
  double cost(std::span<const double> parameters, bool exact, const Stop& stop) const;
  Equations equations(std::span<const double> parameters, const Stop& stop) const;
  void visit_rows(std::span<const double> parameters, const Stop& stop,
                  const std::function<void(const PairRows&)>& visitor) const;
  // The weighted mean of |e|, in the residual's unit.
  double mean_residual(std::span<const double> parameters, const Stop& stop) const;

  // The weighted mean of m, times the cosine where that counts.
  [[nodiscard]] double mean_measured() const { return mean_measured_; }

  // Of pair i: its weight, its cosine (or 1), and the transformed measured value of channel c.
  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }
  [[nodiscard]] const std::vector<double>& cosines() const { return cosines_; }
  [[nodiscard]] std::span<const double> measured(int c) const {
    return std::span(measured_).subspan(static_cast<std::size_t>(c) * data_.size(), data_.size());
  }

 private:
  struct Rows;
  struct Tile {
    std::size_t first, count;
  };
  template <class Visit>
  void visit(std::span<const double> parameters, bool derivatives, const Stop& stop,
             const Visit& visit) const;
  double residuals(Tile tile, int channel, const Loss& loss, Rows& rows) const;
  void add(const Rows& rows, int channel, Equations& to) const;

  const Form& form_;
  const Data& data_;
  Loss loss_;
  std::vector<double> weights_, cosines_, measured_;
  double weight_sum_ = 0, mean_measured_ = 0;
};

}  // namespace gonio::fit
