// Energy of light from one direction, by quadrature. Thread safety: functions without state.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "assess/hemisphere.h"
#include "assess/subject.h"

namespace gonio::assess {

// Where incidences are looked at, in radians: from the normal to 89.9 degrees; along v, too, where
// the material is anisotropic.
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
  // The mean and the variance of weights with those above `cap` taken as that: however heavy the
  // tail, a mean of samples is then within known bounds.
  std::vector<double> cap = {}, capped = {}, variance = {};
};

// Once `stop` says so the numbers are without meaning: whoever asks must ask it again.
Energy integrate_from(const Angles& angles, const Subject& subject,
                      const std::function<bool()>& stop);

}  // namespace gonio::assess
