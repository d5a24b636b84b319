// How far a material is from measured data, by every measure that the field uses, and by zone of
// angles: norms that do not weigh by cosines are ruled by what lies next to the horizon.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "fit/data/data.h"
#include "gonio/engine/material.h"

namespace gonio::fit {

// With w a pair's weight and cos that of incidence, sums over pairs and channels, m measured:
struct Errors {
  double l1 = 0;    // sum w |f - m| cos / sum w m cos
  double rmse = 0;  // sqrt(sum w ((f - m) cos)^2 / sum w), in 1/sr
  double log = 0;   // sum w |log(1 + f cos) - log(1 + m cos)| / sum w
  double cbrt = 0;  // sqrt(sum w (cbrt(f cos) - cbrt(m cos))^2 / sum w)
  std::size_t pairs = 0;
};

inline constexpr double kGrazing = 1.3962634015954636;  // 80 degrees, in radians

// The larger of both angles decides.
struct ErrorsByZone {
  Errors all, below_80, above_80;
};

// A pair at which the material is far off: its share of the sum of w |f - m| cos.
struct Place {
  std::array<double, 3> wi{}, wo{};
  int channel = 0;
  double measured = 0, fitted = 0, share = 0;
};

// What is reflected in a region of directions, as parts of all that is measured (w m cos).
struct Region {
  double measured = 0, fitted = 0, error = 0;  // error: w |f - m| cos
};

// By where wo is: about the mirror direction of wi (25 degrees), else about wi itself, else
// anywhere.
struct Regions {
  Region mirror, toward_light, elsewhere;
};

struct Comparison {
  ErrorsByZone errors;
  Regions regions;
  std::vector<Place> worst;  // the worst first
};

// `worst` is how many places are wanted, no two within `apart` radians of each other in both
// directions. Channels must agree; a material of one channel stands for all.
Comparison compare(const Material& material, const Data& data, std::size_t worst = 5);

}  // namespace gonio::fit
