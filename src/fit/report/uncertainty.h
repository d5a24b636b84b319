// How well the data determine the parameters: curvature, robust standard errors, correlations.
//
// Standard errors are the sandwich H^-1 S H^-1 (Huber 1967; White 1980): S sums the squared scores
// of the pairs, whose channels may err together, and H is the loss's curvature. Of |e| that is
// twice the density of the residuals at 0, estimated among pairs of similar reflectance, since
// noise grows with it (Powell 1991). They hold for models that are wrong, too: then they say how
// the parameters would scatter if other pairs had been measured.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fit/search/problem.h"
#include "gonio/fit/certificate.h"

namespace gonio::fit {

struct Uncertainty {
  double gradient_norm = 0;
  std::vector<ParameterReport> parameters;  // of the material, as a person reads it
  std::vector<Indistinct> indistinct;
  std::vector<std::string> active_bounds;
};

// How the last stage of a fit smooths |e|.
double smooth_of(const Problem& problem, std::span<const double> parameters, const Stop& stop);

// At the minimum `parameters` of a problem whose loss is smoothed as it was last minimised.
// `pairs` is how many the minimum was found on, if more than the problem's.
Uncertainty uncertainty_at(const Problem& problem, std::span<const double> parameters,
                           std::size_t pairs, const Stop& stop);

}  // namespace gonio::fit
