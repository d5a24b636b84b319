// Whether what a fit misses depends on the azimuth of the half-vector, as it does where the
// data are anisotropic along other axes than the material. Thread safety: a function without state.
#pragma once

#include <span>

#include "fit/search/problem.h"

namespace gonio::fit {

// Of the residuals r of m - f, weighted, a pair's channels together: the sum of r exp(2 i phi_h)
// over that of |r|, after what the mean of exp(2 i phi_h) makes of a sum of r that is not 0. 1 at
// most. Residuals that are alike at phi_h and -phi_h have no part along sin(2 phi_h).
struct Pattern {
  double along_cos = 0, along_sin = 0;
  double noise = 0;  // what chance makes of either, one standard deviation
  // How much the azimuths of incidence, and of half-vectors where anything is missed, differ: 0
  // to 1.
  double spread = 0, half_spread = 0;
  // The part along sin(2 (phi_h - phi_i)) about the mean azimuth of incidence, and how much more of
  // the data are on one side of the plane of incidence than on the other, 0 to 1. Whatever is
  // isotropic is alike on both sides.
  double across = 0, one_sided = 0;

  [[nodiscard]] double size() const;
  // What of it no isotropic lobe of another shape would explain, 0 to 1: all, or at one azimuth of
  // incidence, where the shape in its plane and beside it might be wrong, what differs by side.
  [[nodiscard]] double anisotropic() const;
  [[nodiscard]] bool of_one_azimuth() const;
  [[nodiscard]] double degrees() const;  // the axis along which more is measured, in (-90, 90]
};

Pattern pattern_of(const Problem& problem, std::span<const double> parameters, const Stop& stop);

}  // namespace gonio::fit
