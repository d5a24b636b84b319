// Energy and samples of light from one direction. Thread safety: functions without state.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "assess/report.h"

namespace gonio::assess {

// Where incidences are looked at, in radians: from the normal to 89.9 degrees; along v, too, where
// the material is anisotropic.
struct Angles {
  double theta, phi;
};
std::vector<Angles> incidences_of(const Subject& subject, std::uint64_t seed);

// Once `stop` says so the numbers are without meaning: whoever asks must ask it again.
Incidence look_from(const Angles& angles, const Subject& subject, std::uint64_t seed,
                    const std::function<bool()>& stop);

}  // namespace gonio::assess
