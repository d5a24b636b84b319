#include "fit/data/pattern.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace gonio::fit {
namespace {

using Complex = std::complex<double>;

// exp(2 i phi) of a vector's part in the surface; 0 for the normal.
Complex twice_azimuth(double x, double y) {
  const double square = x * x + y * y;
  return square > 0 ? Complex(x, y) * Complex(x, y) / square : Complex();
}

// Of every pair, all channels together: in the form's own unit, and as the objective has them.
std::vector<double> residuals_of(const Problem& problem, std::span<const double> parameters,
                                 const Stop& stop) {
  std::vector<double> residuals(problem.data().size());
  problem.visit_rows(parameters, stop, [&](const PairRows& rows) {
    for (Eigen::Index i = 0; i < rows.residual.size(); ++i)
      residuals[rows.first + static_cast<std::size_t>(i)] -= rows.weight[i] * rows.residual[i];
  });
  return residuals;
}

// The mean of exp(2 i phi_i): its argument says where incidence is from, its size how alike.
Complex incidence_of(const Data& data) {
  Complex sum;
  double weights = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const auto x = static_cast<double>(data.wi[0][i]), y = static_cast<double>(data.wi[1][i]);
    const double weight = static_cast<double>(data.weights[i]) * (x * x + y * y);
    sum += weight * twice_azimuth(x, y);
    weights += weight;
  }
  return weights > 0 ? sum / weights : Complex();
}

}  // namespace

bool Pattern::of_one_azimuth() const {
  constexpr double kOne = 0.3;
  return spread < kOne;
}
double Pattern::anisotropic() const {
  constexpr double kOneSided = 0.35;  // data of one side alone: 0.6
  if (!of_one_azimuth()) return size();
  return one_sided < kOneSided ? std::abs(across) : 0;
}
double Pattern::size() const { return std::hypot(along_cos, along_sin); }
double Pattern::degrees() const {
  return std::atan2(along_sin, along_cos) * (90 / std::numbers::pi);
}

Pattern pattern_of(const Problem& problem, std::span<const double> parameters, const Stop& stop) {
  const Data& data = problem.data();
  const std::vector<double> residuals = residuals_of(problem, parameters, stop);
  std::vector<Complex> phases;
  Complex mean;
  double total = 0, sides = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const auto ix = static_cast<double>(data.wi[0][i]), iy = static_cast<double>(data.wi[1][i]);
    const double hx = ix + static_cast<double>(data.wo[0][i]),
                 hy = iy + static_cast<double>(data.wo[1][i]);
    phases.push_back(twice_azimuth(hx, hy));
    const double size = std::abs(residuals[i]), across = ix * hy - iy * hx,
                 lengths = std::hypot(ix, iy) * std::hypot(hx, hy);
    mean += size * phases[i];
    sides += lengths > 0 ? size * across / lengths : 0;
    total += size;
  }
  if (!(total > 0) || !std::isfinite(total)) return {};
  mean /= total;
  Complex sum;
  double squares = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const double part = residuals[i] / total;
    sum += part * (phases[i] - mean);
    squares += part * part * std::norm(phases[i] - mean);
  }
  const Complex from = incidence_of(data);
  const double alike = std::abs(from);
  const double across = alike > 0 ? (sum * std::conj(from)).imag() / alike : 0;
  Pattern pattern;
  pattern.along_cos = sum.real();
  pattern.along_sin = sum.imag();
  pattern.noise = std::sqrt(squares / 2);
  pattern.spread = 1 - alike;
  pattern.half_spread = 1 - std::abs(mean);
  pattern.across = across;
  pattern.one_sided = std::abs(sides) / total;
  return pattern;
}

}  // namespace gonio::fit
