#include "fit/uncertainty.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "fit/material_numbers.h"
#include "fit/minimise.h"
#include "fit/scores.h"

namespace gonio::fit {
namespace {

constexpr double kNormal95 = 1.959963984540054;
// Eigenvalues of a unit-diagonal matrix below this: a direction that the data do not see.
constexpr double kUnseen = 1e-3;
constexpr double kTogether = 0.98;  // the least correlation that is reported
constexpr double kTakesPart = 0.3;  // a parameter's least share in such a direction

std::string field_of(const Form& form, std::size_t parameter) {
  if (parameter < form.shapes.size()) return form.shapes[parameter].field;
  const std::size_t own = (parameter - form.shapes.size()) % form.coefficients;
  for (const FormLobe& lobe : form.lobes) {
    const std::size_t at = own - lobe.first_coefficient;
    if (own < lobe.first_coefficient || at >= lobe.coefficient_count) continue;
    const bool diffuse = lobe.columns == FormLobe::Columns::diffuse ||
                         lobe.columns == FormLobe::Columns::quadratic_diffuse || at == 2;
    return lobe.prefix + "parameters." + (diffuse ? "rd" : "scale");
  }
  return {};
}

// Directions of nearly no curvature, by the fields that take part. `H` is of the parameters `free`.
std::vector<Indistinct> unseen(const Form& form, const Eigen::MatrixXd& H,
                               const std::vector<std::size_t>& free) {
  const Eigen::VectorXd scale = H.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scale.asDiagonal() * H *
                                                             scale.asDiagonal());
  std::vector<Indistinct> found;
  for (Eigen::Index k = 0; k < eigen.eigenvalues().size(); ++k) {
    if (eigen.eigenvalues()[k] > kUnseen) break;  // they come in rising order
    Indistinct direction{{}, std::max(eigen.eigenvalues()[k], 0.0), {}};
    // Spread over many channels no parameter has much of it: then the largest takes part.
    const auto shares = eigen.eigenvectors().col(k).cwiseAbs();
    const double least = std::min(kTakesPart, 0.999 * shares.maxCoeff());
    for (std::size_t i = 0; i < free.size(); ++i) {
      const std::string field = field_of(form, free[i]);
      const bool known = std::find(direction.fields.begin(), direction.fields.end(), field) !=
                         direction.fields.end();
      if (!known && shares(static_cast<Eigen::Index>(i)) > least) direction.fields.push_back(field);
    }
    if (!direction.fields.empty()) found.push_back(std::move(direction));
  }
  return found;
}

// Pairs of numbers whose estimates go together, each pair of fields once. Those with the same
// `slopes` are one number by the form that is fitted, which says nothing of the data.
void add_correlated(const std::vector<MaterialNumber>& numbers, const Eigen::MatrixXd& slopes,
                    const Eigen::MatrixXd& covariance, std::vector<Indistinct>& to) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t j = i + 1; j < numbers.size(); ++j) {
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
      const double size = std::sqrt(covariance(a, a) * covariance(b, b));
      const double correlation = size > 0 ? covariance(a, b) / size : 0;
      const std::vector fields{numbers[i].field, numbers[j].field};
      if (!(std::abs(correlation) > kTogether) || fields[0] == fields[1]) continue;
      if (slopes.row(a) == slopes.row(b)) continue;
      const bool known = std::any_of(
          to.begin(), to.end(), [&](const Indistinct& other) { return other.fields == fields; });
      if (!known) to.push_back({fields, std::max(1 - std::abs(correlation), 0.0), correlation});
    }
  }
}

// The parameters inside their bounds; the fields of the others go to `active`.
std::vector<std::size_t> inside(const Form& form, std::span<const double> parameters, int channels,
                                std::vector<std::string>& active) {
  const Bounds bounds = bounds_of(form, channels);
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool lower = parameters[i] <= bounds.lower[i] + 1e-9,
               upper = parameters[i] >= bounds.upper[i] - 1e-9;
    if (!lower && !upper) {
      free.push_back(i);
      continue;
    }
    const std::string field = field_of(form, i) + (lower ? " (lower)" : " (upper)");
    if (std::find(active.begin(), active.end(), field) == active.end()) active.push_back(field);
  }
  return free;
}

// Those of the parameters `free` by which anything changes at all.
std::vector<std::size_t> with_curvature(const Eigen::MatrixXd& H,
                                        const std::vector<std::size_t>& free) {
  std::vector<std::size_t> seen;
  for (const std::size_t i : free) {
    if (H(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) > 1e-100) seen.push_back(i);
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

ParameterReport report_of(const MaterialNumber& number, const Says& says, double standard_error) {
  const Parameter& p = *number.parameter;
  ParameterReport report;
  report.field = number.field;
  report.channel = number.channel;
  report.value = number.value;
  report.at_bound = number.value <= p.lower || number.value >= p.upper || says.held;
  report.determined = says.determined && std::isfinite(standard_error);
  report.lower = p.lower;
  report.upper = p.upper;
  if (!report.determined) return report;
  report.standard_error = standard_error;
  if (p.scale == Scale::logarithmic && number.value > 0) {
    const double factor = std::exp(std::min(kNormal95 * standard_error / number.value, 700.0));
    report.lower = number.value / factor;
    report.upper = number.value * factor;
  } else {
    report.lower = number.value - kNormal95 * standard_error;
    report.upper = number.value + kNormal95 * standard_error;
  }
  report.lower = std::max(report.lower, p.lower);
  report.upper = std::min(report.upper, p.upper);
  return report;
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
  const auto free = inside(form, parameters, channels, result.active_bounds);
  const Sandwich sums = sandwich_at(problem, parameters, stop);
  const Equations e = problem.equations(parameters, stop);
  for (const std::size_t i : free) {
    const auto at = static_cast<Eigen::Index>(i);
    const double size = std::sqrt(std::max(2 * e.cost * e.matrix(at, at), 1e-300));
    result.gradient_norm = std::max(result.gradient_norm, std::abs(e.gradient[at]) / size);
  }
  const auto seen = with_curvature(sums.curvature, free);
  const Eigen::MatrixXd H = sums.curvature(seen, seen), S = sums.scatter(seen, seen);
  if (!seen.empty()) result.indistinct = unseen(form, H, seen);
  const Eigen::MatrixXd inverted = seen.empty() ? H : inverse(H);
  const double share = std::min(1.0, static_cast<double>(problem.data().size()) /
                                         static_cast<double>(std::max<std::size_t>(pairs, 1)));
  const auto numbers = numbers_of(form, parameters, channels);
  const Eigen::MatrixXd all = slopes_of(form, parameters, channels, numbers);
  const Eigen::MatrixXd J = all(Eigen::all, seen);
  const Eigen::MatrixXd curved = J * inverted * J.transpose();
  add_correlated(numbers, J, curved, result.indistinct);
  const Eigen::MatrixXd variance = share * J * inverted * S * inverted * J.transpose();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    result.parameters.push_back(report_of(numbers[i], says_of(all, at, free, seen),
                                          std::sqrt(std::max(variance(at, at), 0.0))));
  }
  return result;
}

}  // namespace gonio::fit
