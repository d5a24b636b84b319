// Energy of light from one direction, by quadrature. Thread safety: functions without state.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "assess/hemisphere.h"
#include "assess/subject.h"

namespace gonio::assess {

// The directions of incidence that are examined, in radians: from the normal to 89.9 degrees, for
// anisotropic materials also along v.
struct Angles {
  double theta, phi;
};
std::vector<Angles> incidences_of(const Subject& subject, std::uint64_t seed);

// Nothing here depends on a seed.
struct Energy {
  Angles angles;
  Direction given;  // wi
  Subdivision subdivision;
  std::vector<Bin> bins = {};             // of the pdf, of about equal mass
  double mass = 0, lost = 0, unsure = 0;  // as in Incidence
  std::vector<double> albedo = {};        // of each channel
  std::vector<double> change = {};        // of the albedo, as Subdivision::change
  // The mean and the variance of weights, where those above `cap` count as `cap`. A mean of samples
  // is then within known bounds, however heavy the tail is.
  std::vector<double> cap = {}, capped = {}, variance = {};
};

// After `stop` returned true, which the caller must check, the numbers have no meaning.
Energy integrate_from(const Angles& angles, const Subject& subject,
                      const std::function<bool()>& stop);

}  // namespace gonio::assess
