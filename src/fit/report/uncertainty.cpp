#include "fit/report/uncertainty.h"

#include <algorithm>
#include <cmath>

#include "fit/bounds/active.h"
#include "fit/bounds/coordinates.h"
#include "fit/linear/equations_block.h"
#include "fit/report/indistinct.h"
#include "fit/report/material_numbers.h"
#include "fit/report/scores.h"

namespace gonio::fit {
namespace {

constexpr double kNormal95 = 1.959963984540054;
// A column whose height is below this part of the data's mean is not seen.
constexpr double kNothing = 1e-8;
// A standard error so many times a number says nothing of it.
constexpr double kVague = 10;
constexpr double kBlind = 1e6;

// Those of the coordinates `free` by which anything changes at all: alone, with the others known,
// each would have a standard error that is no more than kBlind times its size.
std::vector<std::size_t> with_curvature(const Sandwich& sums, std::span<const double> coordinates,
                                        const std::vector<std::size_t>& free) {
  std::vector<std::size_t> seen;
  for (const std::size_t i : free) {
    const auto at = static_cast<Eigen::Index>(i);
    const double size = kBlind * std::max(std::abs(coordinates[i]), 1.0);
    const double curvature = sums.curvature(at, at);
    if (curvature > 1e-100 && std::sqrt(std::max(sums.scatter(at, at), 0.0)) < size * curvature)
      seen.push_back(i);
  }
  return seen;
}

// What the data say of a number, by the fit's parameters that it changes with.
struct Says {
  bool held = false;  // it changes with some, all at their bounds or within rounding of them
  bool determined = true;
};

Says says_of(const Eigen::MatrixXd& slopes, Eigen::Index number,
             const std::vector<std::size_t>& free, const std::vector<std::size_t>& seen) {
  const auto has = [](const std::vector<std::size_t>& in, Eigen::Index parameter) {
    return std::find(in.begin(), in.end(), static_cast<std::size_t>(parameter)) != in.end();
  };
  bool any_held = false, any_free = false;
  Says says;
  // The scale of a lobe without height follows its shape by next to nothing.
  const double nothing = 1e-7 * slopes.row(number).cwiseAbs().maxCoeff();
  for (Eigen::Index j = 0; j < slopes.cols(); ++j) {
    if (std::abs(slopes(number, j)) <= nothing) continue;
    const bool is_free = has(free, j);
    any_free = any_free || is_free;
    any_held = any_held || !is_free;
    if (is_free && !has(seen, j)) says.determined = false;
  }
  says.held = any_held && !any_free;
  return says;
}

struct Interval {
  double lower, upper;
};

// At 95 %; for a logarithmic parameter symmetric in its logarithm.
Interval interval_of(const Parameter& p, double value, double standard_error) {
  const double reach = kNormal95 * standard_error;
  if (p.scale != Scale::logarithmic || !(value > 0)) return {value - reach, value + reach};
  const double factor = std::exp(std::min(reach / value, 700.0));
  return {value / factor, value * factor};
}

// Do the data say no more than the model's table does? A scale, whose table hardly bounds it, is
// open where its standard error is far beyond the number itself and the data's size, `unit`.
bool is_open(const Parameter& p, double value, double standard_error, double unit) {
  if (!std::isfinite(standard_error)) return true;
  const Interval interval = interval_of(p, value, standard_error);
  // Where a logarithm has no end below, next to nothing is one.
  const double least = p.scale == Scale::logarithmic ? 1e-3 * p.start : p.lower;
  if (interval.lower <= std::max(p.lower, least) && interval.upper >= p.upper) return true;
  const bool scale = p.type == ParameterType::colour && p.upper > 1 && p.scale == Scale::linear;
  return scale && standard_error > kVague * std::max(value, unit);
}

// `unit`: of colours, by the data's size.
ParameterReport report_of(const MaterialNumber& number, const Says& says, double standard_error,
                          double unit) {
  const Parameter& p = *number.parameter;
  ParameterReport report;
  report.field = number.field;
  report.channel = number.channel;
  report.value = number.value;
  report.at_bound = number.value <= p.lower || number.value >= p.upper || says.held;
  report.undetermined = !says.determined || is_open(p, number.value, standard_error, unit);
  report.lower = p.lower;
  report.upper = p.upper;
  if (report.undetermined) return report;
  const Interval interval = interval_of(p, number.value, standard_error);
  report.standard_error = standard_error;
  report.lower = std::max(interval.lower, p.lower);
  report.upper = std::min(interval.upper, p.upper);
  return report;
}

// The largest slope of a coordinate that is free, each scaled by its own curvature.
double gradient_norm(const Equations& e, const std::vector<std::size_t>& free) {
  double norm = 0;
  for (const std::size_t i : free) {
    const auto at = static_cast<Eigen::Index>(i);
    const double size = std::sqrt(std::max(2 * e.cost * e.matrix(at, at), 1e-300));
    norm = std::max(norm, std::abs(e.gradient[at]) / size);
  }
  return norm;
}

// The problem's pairs as a part of those that the minimum was found on.
double share_of(const Problem& problem, std::size_t pairs) {
  return std::min(1.0, static_cast<double>(problem.data().size()) /
                           static_cast<double>(std::max<std::size_t>(pairs, 1)));
}

}  // namespace

double smooth_of(const Problem& problem, std::span<const double> parameters, const Stop& stop) {
  constexpr double kSmooth = 0.001;  // of the mean residual
  return std::max(kSmooth * problem.mean_residual(parameters, stop), 1e-12);
}

Uncertainty uncertainty_at(const Problem& problem, std::span<const double> parameters,
                           std::size_t pairs, const Stop& stop) {
  Uncertainty result;
  const Form& form = problem.form();
  const int channels = problem.data().channels;
  const double nothing = kNothing * problem.mean_measured();
  result.active_bounds = active_bounds(form, parameters, channels, nothing);
  Coordinates coordinates(form, channels);
  coordinates.follow(parameters, 1 - kAtBound);
  const std::vector<double> at_end = coordinates.from_parameters(parameters);
  const Eigen::MatrixXd T = coordinates.slopes(at_end);
  const auto free = inside_bounds(form, at_end, coordinates.bounds(), nothing);
  Sandwich sums = sandwich_at(problem, parameters, stop);
  sums.curvature = T.transpose() * sums.curvature * T;
  sums.scatter = T.transpose() * sums.scatter * T;
  result.gradient_norm = gradient_norm(equations_at(problem, coordinates, at_end, stop), free);
  const auto seen = with_curvature(sums, at_end, free);
  const Eigen::MatrixXd H = sums.curvature(seen, seen), S = sums.scatter(seen, seen);
  if (!seen.empty()) result.indistinct = unseen_directions(coordinates, H, seen);
  const Eigen::MatrixXd inverted = seen.empty() ? H : inverse(H);
  const auto numbers = numbers_of(form, parameters, channels);
  const Eigen::MatrixXd all = slopes_of(form, parameters, channels, numbers) * T;
  const Eigen::MatrixXd J = all(Eigen::all, seen);
  const Eigen::MatrixXd curved = J * inverted * J.transpose();
  add_correlated(numbers, J, curved, result.indistinct);
  const Eigen::MatrixXd variance =
      share_of(problem, pairs) * J * inverted * S * inverted * J.transpose();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    result.parameters.push_back(report_of(numbers[i], says_of(all, at, free, seen),
                                          std::sqrt(std::max(variance(at, at), 0.0)), form.unit));
  }
  return result;
}

}  // namespace gonio::fit
