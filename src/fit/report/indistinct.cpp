#include "fit/report/indistinct.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace gonio::fit {
namespace {

// Eigenvalues of a unit-diagonal matrix below this: a direction that the data do not see.
constexpr double kUnseen = 1e-3;
constexpr double kTogether = 0.98;   // the least correlation that is reported
constexpr double kTakesPart = 0.3;   // a parameter's least share in such a direction
constexpr double kLeastPart = 1e-3;  // and of one that goes with it

// Adds the fields that are not there yet.
void add_fields(const std::vector<std::string>& from, std::vector<std::string>& to) {
  for (const std::string& field : from) {
    if (std::find(to.begin(), to.end(), field) == to.end()) to.push_back(field);
  }
}

// The fields that take part in a direction, by their `shares` in it. With a unit diagonal none is
// unseen by itself: where one field alone has a large share, the next goes with it.
std::vector<std::string> taking_part(const Coordinates& coordinates, const Eigen::VectorXd& shares,
                                     const std::vector<std::size_t>& free) {
  // Spread over many channels no parameter has much of it: then the largest takes part.
  const double least = std::min(kTakesPart, 0.999 * shares.maxCoeff());
  std::vector<std::size_t> order(free.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto share = [&](std::size_t i) { return shares[static_cast<Eigen::Index>(i)]; };
  std::vector<std::string> fields;
  for (const std::size_t i : order) {
    if (share(i) > least) add_fields(coordinates.fields(free[i]), fields);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return share(a) > share(b); });
  for (const std::size_t i : order) {
    if (fields.size() > 1 || share(i) < kLeastPart) break;
    add_fields(coordinates.fields(free[i]), fields);
  }
  return fields;
}

}  // namespace

std::vector<Indistinct> unseen_directions(const Coordinates& coordinates, const Eigen::MatrixXd& H,
                                          const std::vector<std::size_t>& free) {
  const Eigen::VectorXd scale = H.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scale.asDiagonal() * H *
                                                             scale.asDiagonal());
  std::vector<Indistinct> found;
  for (Eigen::Index k = 0; k < eigen.eigenvalues().size(); ++k) {
    if (eigen.eigenvalues()[k] > kUnseen) break;  // they come in rising order
    Indistinct direction{{}, std::max(eigen.eigenvalues()[k], 0.0), {}};
    direction.fields = taking_part(coordinates, eigen.eigenvectors().col(k).cwiseAbs(), free);
    if (!direction.fields.empty()) found.push_back(std::move(direction));
  }
  return found;
}

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

}  // namespace gonio::fit
