// The parameters of a fit as a descent moves them within the bounds of the models' tables.
//
// By coefficients, as long as no bound but those of single coefficients is near. A lobe that meets
// another one goes by its colours (colour.h): there that bound is an interval, too, and a lobe
// whose scale is held changes its height with its shape. Thread safety: const functions only read.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "fit/bounds/colour.h"
#include "fit/form.h"

namespace gonio::fit {

struct Bounds {
  std::vector<double> lower, upper;
};

// The parameters moved into the bounds of the models' tables; untouched where they are inside.
std::vector<double> within_bounds(const Form& form, std::span<const double> parameters,
                                  int channels);

class Coordinates {
 public:
  Coordinates(const Form& form, int channels);

  // From now on, lobes whose colours at `parameters` are above the part `near` of an upper bound,
  // or beyond any bound, go by their colours. Whether there are any new ones.
  bool follow(std::span<const double> parameters, double near);
  // Does every lobe go by its coefficients? Coordinates are parameters then.
  [[nodiscard]] bool plain() const { return by_colour_.empty(); }

  [[nodiscard]] std::vector<double> from_parameters(std::span<const double> parameters) const;
  [[nodiscard]] std::vector<double> to_parameters(std::span<const double> coordinates) const;
  // d parameters / d coordinates.
  [[nodiscard]] Eigen::MatrixXd slopes(std::span<const double> coordinates) const;
  [[nodiscard]] Bounds bounds() const;
  // The material's numbers that a coordinate moves, as errors name them.
  [[nodiscard]] std::vector<std::string> fields(std::size_t coordinate) const;

 private:
  // A lobe that goes by its colours in one channel.
  struct ByColour {
    std::size_t lobe, first;  // the first of its parameters in that channel
  };
  [[nodiscard]] bool goes_by_colour(std::size_t first) const;

  const Form& form_;
  int channels_;
  std::vector<ByColour> by_colour_;
};

}  // namespace gonio::fit
