// Parameters and numbers that the data do not tell apart. Thread safety: functions without state.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/bounds/coordinates.h"
#include "fit/report/material_numbers.h"
#include "gonio/fit/certificate.h"

namespace gonio::fit {

// Directions of nearly no curvature, by the fields that take part. `H` is of the coordinates
// `free`.
std::vector<Indistinct> unseen_directions(const Coordinates& coordinates, const Eigen::MatrixXd& H,
                                          const std::vector<std::size_t>& free);

// Pairs of numbers whose estimates go together, each pair of fields once. Those with the same
// `slopes` are one number by the form that is fitted, which says nothing of the data.
void add_correlated(const std::vector<MaterialNumber>& numbers, const Eigen::MatrixXd& slopes,
                    const Eigen::MatrixXd& covariance, std::vector<Indistinct>& to);

}  // namespace gonio::fit
